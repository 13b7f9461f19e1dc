/* Directions drawn from the sky in proportion to its luminance: the sky's patches cut into bins of one
 * probability (glsl/pass/sky_sampler.glsl). */
#pragma once

#include "sky/sky_patches.h"

enum { SKY_BIN_COLUMNS = 256, SKY_BIN_ROWS = 128, SKY_BINS = SKY_BIN_COLUMNS * SKY_BIN_ROWS };

typedef struct SkySampler {
    const GlApi *gl;
    GLuint bins, shares; /* textures */
    SkyState filled_for;
    int fills;
} SkySampler;

MUST_CHECK bool sky_sampler_create(SkySampler *sampler, const Context *context, Error *error);
void sky_sampler_destroy(SkySampler *sampler);

/* Fills the table if the sky has changed, and tells `program`, which becomes the program in use. */
MUST_CHECK bool sky_sampler_use(SkySampler *sampler, SkyPatches *patches, Sky *sky, const Program *program,
                                const SkyState *state, Error *error);

/* Puts the tables on their texture units. */
void sky_sampler_bind(const SkySampler *sampler);

/* Shares SKY_BINS bins among cells in proportion to their weights, in whole numbers, at least one bin to each
 * cell of a weight above 0 (fewer of those than bins, and at least one). */
void sky_sampler_share(const double *weights, int cells, int *bins);
