/* What several commands start with: where the GLSL library is, and a scene with the command line's settings
 * made. */
#pragma once

#include "base/options.h"
#include "image/image.h"
#include "scene/scene.h"

#define MAGICHOUR_VERSION "0.1.0"

/* The GLSL library's folder: --glsl-dir, else the first glsl/ (or share/magichour/glsl/) found going up from
 * the program's own folder. To be freed. */
MUST_CHECK bool setup_library(const Options *options, char **library, Error *error);

/* Reads the scene (without a file: an empty one, for the sky), then applies in this order: --preset,
 * --atmosphere, --sun, --set. */
MUST_CHECK bool setup_scene(const Options *options, Scene *scene, Error *error);

/* Metadata: "magichour.GROUP.NAME" with one number or three, and all of the atmosphere's. */
void setup_describe_value(AttributeList *list, const char *group, const char *name, const double *value,
                          int count);
void setup_describe_atmosphere(const Atmosphere *atmosphere, AttributeList *list);
