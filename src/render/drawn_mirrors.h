/* The mirror spheres that a scene defines in GLSL. A small program draws their numbers and the host reads
 * them back, because it must find the pixels in which they may show the sun. */
#pragma once

#include "gl/resource.h"
#include "sky/frame.h"

/* One sphere in each texel. It is filled only if the picture shows the sun's image and the scene defines
 * mirror_sphere(). */
extern const ResourceKind drawn_mirrors;

/* Draws and reads the spheres if the frame needs them. `spheres` receives them, and frame->mirrors then
 * points to it. drawn_mirrors must be the first of `tables`, and `uniforms` holds the frame's uniforms. */
MUST_CHECK bool drawn_mirrors_ask(const Resources *tables, Frame *frame, Uniforms *uniforms,
                                  double spheres[MOST_HINTS][4], Error *error);
