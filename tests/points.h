/* Pairs of points, and what GLSL makes of them. An item is a pair of texels: eight numbers, of which the
 * first four are those of the point p and the others those of q. */
#pragma once

#include "gl/context.h"

/* Puts p within `reach` of the origin in each coordinate, and q within `step` of it, shortened by up to so
 * many powers of ten (`decades`). */
void points_make(float *inputs, int items, double reach, double step, double decades);

/* Evaluates `body`, which sets the vec4 c by p and q, once for each texel of width x height. `declarations`
 * go before it. */
void points_evaluate(const Context *context, const char *declarations, const char *body, const float *inputs,
                     int width, int height, float *results);
