/* The numbers of mirror spheres that a scene defines in GLSL: drawn by a small program and read back, for the
 * host has to know where in the picture they may show the sun. */
#pragma once

#include "gl/resource.h"
#include "sky/frame.h"

/* One sphere a texel. Wanted only where the sun's image is drawn and the scene defines mirror_sphere(). */
extern const ResourceKind drawn_mirrors;

/* Draws them for this frame, if the frame wants them, and gives them to it: `spheres` is what frame->mirrors
 * then points to. `tables` has drawn_mirrors first, and `uniforms` holds what the frame tells all programs.
 */
MUST_CHECK bool drawn_mirrors_ask(const Resources *tables, Frame *frame, Uniforms *uniforms,
                                  double spheres[MOST_HINTS][4], Error *error);
