/* The sky as a list of small patches, for integrals over it and for sampling directions from it. The list
 * covers the half of the sky on one side of the sun's vertical plane; the other half is its mirror image. See
 * glsl/pass/fill_radiance.glsl. */
#pragma once

#include "sky/sky.h"

enum {
    PATCH_COLUMNS = 64,
    PATCH_ROWS_ABOVE = 64,
    PATCH_ROWS_BELOW = 32,
    PATCH_ROWS = PATCH_ROWS_ABOVE + PATCH_ROWS_BELOW
};

/* Texture 0 holds the radiance times the patch's solid angle, and the solid angle in steradians. Texture 1
 * holds the patch's direction: the components toward the sun's azimuth, up, and sideways. */
extern const ResourceKind sky_patches;
