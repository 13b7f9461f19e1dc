/* A scene's many spheres (`//@ spheres`), made ready for hit_spheres(). They come from the scene's own
 * function scene_sphere() or from a file, are sorted into a tree, and the tree becomes a texture. */
#pragma once

#include "gl/resource.h"
#include "sky/frame.h"

/* The first table holds what scene_sphere() returns for the numbers from 0, for the host to read. The second
 * is the tree made of it. Spheres that are not finite or too many for this OpenGL are STATUS_SCENE. */
extern const ResourceKind drawn_spheres, scene_spheres;

/* The same tree, made of the spheres in a file. Errors in the file are STATUS_SCENE. */
extern const ResourceKind file_spheres;

/* The file for the slot <spheres> of a program that includes the scene. */
const char *spheres_slot(const Scene *scene);
