#include "sky/sky_sampler.h"

#include "base/memory.h"
#include "base/vec3.h"
#include "gl/texture.h"

#include <math.h>
#include <stdlib.h>

enum { BINS_UNIT = 7, SHARES_UNIT = 8, CELLS = PATCH_COLUMNS * PATCH_ROWS };

bool sky_sampler_create(SkySampler *sampler, const Context *context, Error *error) {
    const GlApi *gl = &context->gl;
    *sampler = (SkySampler){.gl = gl};
    sampler->bins = texture_create(gl, SKY_BIN_COLUMNS, SKY_BIN_ROWS, GL_NEAREST, NULL);
    sampler->shares = texture_create(gl, PATCH_COLUMNS, PATCH_ROWS, GL_NEAREST, NULL);
    return gl_check(gl, "the sky's sampler", error);
}

void sky_sampler_destroy(SkySampler *sampler) {
    if (sampler->bins) sampler->gl->DeleteTextures(1, &sampler->bins);
    if (sampler->shares) sampler->gl->DeleteTextures(1, &sampler->shares);
    *sampler = (SkySampler){0};
}

void sky_sampler_share(const double *weights, int cells, int *bins) {
    double total = 0, passed = 0;
    int wanted = 0, given = 0;
    for (int i = 0; i < cells; i++) {
        total += weights[i];
        wanted += weights[i] > 0;
    }
    /* One bin each, and the others by rounding the running sum, which loses none. */
    for (int i = 0; i < cells; i++) {
        passed += weights[i];
        int upto = (int)lround(passed / total * (SKY_BINS - wanted));
        bins[i] = weights[i] > 0 ? 1 + upto - given : 0;
        given = upto;
    }
}

/* The cell at a place along Hilbert's curve through a square of side `side`, a power of two. */
static void hilbert(int side, int place, int *x, int *y) {
    *x = *y = 0;
    for (int s = 1; s < side; s *= 2, place /= 4) {
        int rx = 1 & (place / 2), ry = 1 & (place ^ rx);
        if (!ry) {
            if (rx) *x = s - 1 - *x, *y = s - 1 - *y;
            int swap = *x;
            *x = *y, *y = swap;
        }
        *x += s * rx;
        *y += s * ry;
    }
}

/* Cells above the horizon along the curve, then the others row by row. */
static int cell_at(int place) {
    int x, y;
    if (place >= PATCH_COLUMNS * PATCH_ROWS_ABOVE) return place;
    hilbert(PATCH_COLUMNS, place, &x, &y);
    return y * PATCH_COLUMNS + x;
}

/* The patches' luminance times their solid angle, and a hundredth of the mean where that is nothing: no
 * direction of the sky is left out. The sine of elevation, the cosine on level ground, is not in it: with it,
 * what stands upright under a low sun is 1.7 times as noisy, and the ground no better. */
static void weigh(const float *light, const float *direction, double *weights) {
    double total = 0;
    for (int i = 0; i < CELLS; i++) {
        double luminance = 0.2126 * (double)light[4 * i] + 0.7152 * (double)light[4 * i + 1] +
                           0.0722 * (double)light[4 * i + 2];
        weights[i] = direction[4 * i + 1] > 0 ? luminance : 0;
        total += weights[i];
    }
    double solid_angle = 2 * pi;
    for (int i = 0; i < CELLS; i++) {
        bool above = direction[4 * i + 1] > 0;
        weights[i] += above ? (total > 0 ? 0.01 * total : 1) * (double)light[4 * i + 3] / solid_angle : 0;
    }
}

static void read_texture(const SkyPatches *patches, GLenum attachment, float *texels) {
    const GlApi *gl = patches->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, patches->framebuffer);
    gl->ReadBuffer(attachment);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, PATCH_COLUMNS, PATCH_ROWS, GL_RGBA, GL_FLOAT, texels);
}

static void upload(SkySampler *sampler, const double *weights) {
    float *bins = memory_get(SKY_BINS, 4 * sizeof *bins), *shares = memory_get(CELLS, 4 * sizeof *shares);
    double *ordered = memory_get(CELLS, sizeof *ordered);
    int *counts = memory_get(CELLS, sizeof *counts), first = 0;
    for (int i = 0; i < CELLS; i++) ordered[i] = weights[cell_at(i)];
    sky_sampler_share(ordered, CELLS, counts);
    for (int i = 0; i < CELLS; i++) {
        int cell = cell_at(i);
        for (int k = first; k < first + counts[i]; k++) {
            bins[4 * k] = (float)cell;
            bins[4 * k + 1] = (float)first;
            bins[4 * k + 2] = (float)counts[i];
            bins[4 * k + 3] = 0;
        }
        for (int c = 0; c < 4; c++) shares[4 * cell + c] = (float)counts[i] / SKY_BINS;
        first += counts[i];
    }
    texture_resize(sampler->gl, sampler->bins, SKY_BIN_COLUMNS, SKY_BIN_ROWS, bins);
    texture_resize(sampler->gl, sampler->shares, PATCH_COLUMNS, PATCH_ROWS, shares);
    free(bins);
    free(shares);
    free(ordered);
    free(counts);
}

static bool fill(SkySampler *sampler, SkyPatches *patches, Sky *sky, const SkyState *state, Error *error) {
    if (!sky_patches_fill(patches, sky, state, error)) return false;
    float *light = memory_get(CELLS, 4 * sizeof *light),
          *direction = memory_get(CELLS, 4 * sizeof *direction);
    double *weights = memory_get(CELLS, sizeof *weights);
    read_texture(patches, GL_COLOR_ATTACHMENT0, light);
    read_texture(patches, GL_COLOR_ATTACHMENT1, direction);
    weigh(light, direction, weights);
    upload(sampler, weights);
    free(light);
    free(direction);
    free(weights);
    sampler->filled_for = *state;
    sampler->fills++;
    return gl_check(sampler->gl, "filling the sky's sampler", error);
}

void sky_sampler_bind(const SkySampler *sampler) {
    if (!sampler->gl) return;
    sampler->gl->ActiveTexture(GL_TEXTURE0 + BINS_UNIT);
    sampler->gl->BindTexture(GL_TEXTURE_2D, sampler->bins);
    sampler->gl->ActiveTexture(GL_TEXTURE0 + SHARES_UNIT);
    sampler->gl->BindTexture(GL_TEXTURE_2D, sampler->shares);
    sampler->gl->ActiveTexture(GL_TEXTURE0);
}

bool sky_sampler_use(SkySampler *sampler, SkyPatches *patches, Sky *sky, const Program *program,
                     const SkyState *state, Error *error) {
    static const double count[3] = {PATCH_COLUMNS, PATCH_ROWS_ABOVE, PATCH_ROWS_BELOW};
    bool filled = sampler->fills && sky_state_serves(&sampler->filled_for, state);
    if (!filled && !fill(sampler, patches, sky, state, error)) return false;
    sky_sampler_bind(sampler);
    program_use(program);
    program_set_int(program, "sky_bins", BINS_UNIT);
    program_set_int(program, "sky_cell_share", SHARES_UNIT);
    program_set_vec3(program, "sky_cells_count", count);
    program_set_float(program, "sky_cells_horizon", sky_horizon_sine(&state->atmosphere));
    program_set_vec3(program, "sky_cells_level", state->sun.level);
    return gl_check(sampler->gl, "setting up the sky's sampler", error);
}
