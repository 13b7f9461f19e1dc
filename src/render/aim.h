/* Where light paths go: they cross a plane that faces the sun, on which they are dense where surfaces throw
 * light into the picture (glsl/sun/aim.glsl). */
#pragma once

#include <stdbool.h>

/* The nodes of five levels: 1 + 4 + 16 + 64 + 256. */
enum { AIM_NODES = 341 };

typedef struct Aim {
    /* The least and the largest coordinates of the rectangle in which they cross the plane, in metres. */
    double box[4];
    /* The distances from the origin toward the sun of the plane, and of the places where they begin. */
    double plane, top;
    /* Whether anything throws light. If not, the rest means nothing. */
    bool any;
    /* 4 floats for each node, as glsl/sun/aim.glsl describes them. */
    float nodes[AIM_NODES][4];
} Aim;

/* Sets the plane and the rectangle from places that throw light: `places` has 4 floats for each, two
 * coordinates on the plane, one toward the sun, and 0 where there is no place. `spread` is the tangent of the
 * disk's angular radius. The tree is made from the same places. */
void aim_begin(Aim *aim, const float *places, int count, double spread);

/* Makes the tree from the light that paths brought: `starts` has 4 floats for each path, two coordinates on
 * the plane, one that is not used, and the light. */
void aim_improve(Aim *aim, const float *starts, int count);
