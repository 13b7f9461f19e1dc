/* Values that no surface can have, looked for in what a scene itself reports: normals that are not of unit
 * length, albedos and roughnesses that are not from 0 to 1, indices of refraction that are not above 0,
 * densities of mist that are not from 0 to 1.
 * Pictures are made with values that are put right (glsl/light/surface.glsl), and whoever renders one says
 * so. Tracks through mist that end before their way does are counted. Scenes that are too far from the origin
 * are noticed as well. */
#pragma once

#include "render/aov.h"

enum { CHECK_KINDS = 8 };

/* The worst value of a kind among the surfaces that were met, and the object that has it. */
typedef struct CheckValue {
    double value;
    int object;
} CheckValue;

typedef struct Check {
    /* Whether it was made at all. If not, nothing is found. */
    bool done;
    CheckValue worst[CHECK_KINDS];
    /* Of the ways through mist of scene_mist() on these paths, and of those from their hits to the sun: the
     * share whose track ends too early, and the share of the light that comes through for this alone. */
    double tracks_cut, track_light;
    /* The line of the mist's annotation. */
    int mist_line;
} Check;

/* Follows a few paths for each pixel of a coarse picture with the same view, which takes some milliseconds
 * besides compiling a small program. */
MUST_CHECK bool check_scene(Check *check, const Context *context, const RenderParams *params,
                            const Renderer *renderer, Error *error);

/* Appends a line for each kind of value that is wrong, such as "object 8 has an albedo of 1.8; ...". With the
 * scene's path each line is a warning of the program's. */
void check_print(const Check *check, const char *path, Text *out);
