/* The first steps of several commands: find the GLSL library, and read a scene with the command line's
 * settings. */
#pragma once

#include "cmd/options.h"
#include "render/plan.h"

/* Finds the GLSL library's folder: --glsl-dir, else the first glsl/ (or share/magichour/glsl/) on the way up
 * from the program's own folder. The caller frees it. */
MUST_CHECK bool setup_library(const Options *options, char **library, Error *error);

/* Finds the scene (cmd/scene_find.h) and reads it with the GLSL library in the folder `library`, or makes an
 * empty one for the sky if there is no file; then `library` may be NULL. Then it applies --preset,
 * --atmosphere, --sun and --set, in this order. */
MUST_CHECK bool setup_scene(const Options *options, const char *library, Scene *scene, Error *error);

/* What the options say of a render of the scene: its methods, size, seed and depth. What was not given has
 * the value that stands for the default. */
RenderParams setup_params(const Options *options, const Scene *scene);
