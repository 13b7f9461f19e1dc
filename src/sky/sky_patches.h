/* The sky as a list of small patches, for integrals over it and for drawing directions from it: half of it,
 * up to the sun's azimuth plane about which it is even. See glsl/pass/fill_radiance.glsl. */
#pragma once

#include "sky/sky.h"

enum {
    PATCH_COLUMNS = 64,
    PATCH_ROWS_ABOVE = 64,
    PATCH_ROWS_BELOW = 32,
    PATCH_ROWS = PATCH_ROWS_ABOVE + PATCH_ROWS_BELOW
};

/* Texture 0: radiance times the patch's solid angle, and that angle. Texture 1: the patch's direction, toward
 * the sun's azimuth, up and aside. */
extern const ResourceKind sky_patches;
