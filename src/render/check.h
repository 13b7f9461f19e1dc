/* Values that no surface can have, looked for in what a scene itself reports: normals that are not of unit
 * length, albedos below 0 or above 1. Pictures are made with values that are put right
 * (glsl/light/surface.glsl), and whoever renders one says so. Scenes that are too far from the origin are
 * noticed as well. */
#pragma once

#include "render/aov.h"

typedef struct Check {
    /* Whether it was made at all. If not, nothing is found. */
    bool done;
    /* The length of the normal that is farthest from 1, the least and the largest albedo among the surfaces
     * that were met, and the objects that have them. */
    double normal_length, least_albedo, largest_albedo;
    int normal_object, least_object, largest_object;
    /* The largest coordinate of a surface that the camera sees, over its distance from the camera; and its
     * object. */
    double size_over_distance;
    int far_object;
} Check;

/* Follows a few paths for each pixel of a coarse picture with the same view, which takes some milliseconds
 * besides compiling a small program. */
MUST_CHECK bool check_scene(Check *check, const Context *context, const RenderParams *params,
                            const Renderer *renderer, Error *error);

bool check_finds_normal(const Check *check);
bool check_finds_albedo(const Check *check);

/* The error, in percent, that surfaces make whose coordinates are large beside their distance: rays start a
 * few float steps above the surfaces that they leave, and the steps grow with the coordinates. A ball on a
 * plane, seen from 4 m, was off by 0.02 % at 1 km from the origin, by 0.10 % at 10 km, 0.8 % at 100 km,
 * and 1.9 % at 1000 km. This is a straight line above these figures. */
double check_far_error(const Check *check);
