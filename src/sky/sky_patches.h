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

typedef struct SkyPatches {
    const GlApi *gl;
    Program program;
    GLuint light, direction, framebuffer; /* textures of PATCH_COLUMNS x PATCH_ROWS */
} SkyPatches;

MUST_CHECK bool sky_patches_create(SkyPatches *patches, const Context *context, const char *library,
                                   const MethodChoice *sky, const Atmosphere *atmosphere, Error *error);
void sky_patches_destroy(SkyPatches *patches);

/* Fills the textures. The framebuffer and the program in use change. */
MUST_CHECK bool sky_patches_fill(SkyPatches *patches, Sky *sky, const SkyState *state, Error *error);
