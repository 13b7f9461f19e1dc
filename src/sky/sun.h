/* The sun's disk in a picture: what its GLSL (glsl/sun/) is told, and where in the picture its own image may
 * be. */
#pragma once

#include "choice/method.h"
#include "gl/camera.h"
#include "sky/sky.h"

enum { SUN_SLOTS = 7, MOST_SUN_RECTANGLES = 1 + MOST_HINTS };

typedef struct SunTables {
    const GlApi *gl;
    GLuint table, cover; /* textures; 0 where the disk is off */
    Rectangle covered;   /* the pixels of `cover`; empty where the unblocked disk is not known exactly */
    Rectangle rectangles[MOST_SUN_RECTANGLES]; /* that hold the disk's image; they may overlap */
    int rectangle_count;
} SunTables;

/* The method that `text` names, NULL for what the scene says; "off" where the disk has set. */
MUST_CHECK bool sun_choose(MethodChoice *choice, const char *text, const Scene *scene, Error *error);

/* Fills slots[0 .. SUN_SLOTS): <sun>, <sun-image>, <mirrors>, <mirrors-image>, <mirror-spheres>, <planes>,
 * <mirror-planes>. `image`: for the program that draws the disk's image; `spheres` and `planes` are GLSL that
 * they refer to. */
void sun_slots(const MethodChoice *choice, const Scene *scene, bool image, const char *spheres,
               const char *planes, GlslSlot *slots);

/* The disk as the scene has it: makes its textures and finds the rectangles. */
MUST_CHECK bool sun_create(SunTables *sun, const Context *context, const MethodChoice *choice,
                           const Scene *scene, const Camera *camera, Error *error);
void sun_destroy(SunTables *sun);

/* Puts the disk's textures on their units. */
void sun_bind(const SunTables *sun);

/* Tells `program`, which is in use. */
void sun_use(const SunTables *sun, const Program *program, const Scene *scene, const Camera *camera);
