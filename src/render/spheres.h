/* A scene's many spheres (`//@ spheres`), made ready for hit_spheres(): counted out by the scene's own
 * scene_sphere(), or read from a file; put into a tree, and that into a texture. */
#pragma once

#include "gl/resource.h"
#include "sky/frame.h"

/* What scene_sphere() makes of the numbers from 0, for the host to read; and the table that is made of it.
 * STATUS_SCENE for spheres that are not finite or too many for this OpenGL. */
extern const ResourceKind drawn_spheres, scene_spheres;

/* The same table, of spheres in a file. STATUS_SCENE for errors in the file. */
extern const ResourceKind file_spheres;

/* The file for the slot <spheres> of a program that holds the scene. */
const char *spheres_slot(const Scene *scene);
