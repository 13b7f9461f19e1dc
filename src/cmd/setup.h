/* What several commands start with: where the GLSL library is, and a scene with the command line's settings
 * made. */
#pragma once

#include "cmd/options.h"
#include "scene/scene.h"

/* The GLSL library's folder: --glsl-dir, else the first glsl/ (or share/magichour/glsl/) found going up from
 * the program's own folder. To be freed. */
MUST_CHECK bool setup_library(const Options *options, char **library, Error *error);

/* Reads the scene (without a file: an empty one, for the sky), then applies in this order: --preset,
 * --atmosphere, --sun, --set. */
MUST_CHECK bool setup_scene(const Options *options, Scene *scene, Error *error);
