/* A scene's many spheres (`//@ spheres`), made ready for hit_spheres(): counted out by the scene's own
 * scene_sphere(), or read from a file; put into a tree, and that into a texture. */
#pragma once

#include "gl/program.h"
#include "scene/scene.h"

typedef struct Spheres {
    const GlApi *gl;
    int max_texture_size;
    Program fill; /* draws scene_sphere(i); empty for a file */
    GLuint table;
    int entries; /* of each of the table's lists (scene/sphere_tree.h) */
} Spheres;

/* Compiles what it needs and fills the table. Nothing where the scene has no such spheres. */
MUST_CHECK bool spheres_create(Spheres *spheres, const Context *context, const char *library,
                               const Scene *scene, Error *error);
void spheres_destroy(Spheres *spheres);

/* Makes the spheres anew from the scene's values as they are. The program in use and the framebuffer that is
 * bound change. STATUS_SCENE for spheres that are not finite or too many for this OpenGL, and errors in the
 * file. */
MUST_CHECK bool spheres_fill(Spheres *spheres, const Scene *scene, Error *error);

/* The file for the slot <spheres> of a program that holds the scene. */
const char *spheres_slot(const Scene *scene);

/* Puts the table on its texture unit. */
void spheres_bind(const Spheres *spheres);

/* Tells `program`, which is in use. */
void spheres_use(const Spheres *spheres, const Program *program);
