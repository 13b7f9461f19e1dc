#include "sky/sky_sampler.h"

#include "base/memory.h"
#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>

enum { CELLS = PATCH_COLUMNS * PATCH_ROWS };

void sky_sampler_share(const double *weights, int cells, int *bins) {
    double total = 0, passed = 0;
    int wanted = 0, given = 0;
    for (int i = 0; i < cells; i++) {
        total += weights[i];
        wanted += weights[i] > 0;
    }
    /* Each cell gets one bin. The others are shared by rounding the running sum, which loses none. */
    for (int i = 0; i < cells; i++) {
        passed += weights[i];
        int upto = (int)lround(passed / total * (SKY_BINS - wanted));
        bins[i] = weights[i] > 0 ? 1 + upto - given : 0;
        given = upto;
    }
}

/* The cell at a place along Hilbert's curve through a square. `side` is a power of two. */
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

/* Cells above the horizon follow the curve; the others come after them, row by row. */
static int cell_at(int place) {
    int x, y;
    if (place >= PATCH_COLUMNS * PATCH_ROWS_ABOVE) return place;
    hilbert(PATCH_COLUMNS, place, &x, &y);
    return y * PATCH_COLUMNS + x;
}

/* A weight is the patch's luminance times its solid angle. Where that is 0 it is a hundredth of the mean,
 * so that every direction of the sky can be sampled. The sine of elevation, which is the cosine on level
 * ground, is left out: with it, upright surfaces under a low sun are 1.7 times as noisy and the ground is
 * no better. */
static void weigh(const float *light, const float *direction, double *weights) {
    double total = 0;
    for (int i = 0; i < CELLS; i++) {
        double luminance = 0.2126 * (double)light[4 * i] + 0.7152 * (double)light[4 * i + 1] +
                           0.0722 * (double)light[4 * i + 2];
        weights[i] = direction[4 * i + 1] > 0 ? fmax(luminance, 0) : 0;
        total += weights[i];
    }
    double solid_angle = 2 * pi;
    for (int i = 0; i < CELLS; i++) {
        bool above = direction[4 * i + 1] > 0;
        weights[i] += above ? (total > 0 ? 0.01 * total : 1) * (double)light[4 * i + 3] / solid_angle : 0;
    }
}

static void upload(Resource *sampler, const double *weights) {
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
    resource_upload(sampler, 0, SKY_BIN_COLUMNS, SKY_BIN_ROWS, bins);
    resource_upload(sampler, 1, PATCH_COLUMNS, PATCH_ROWS, shares);
    free(bins);
    free(shares);
    free(ordered);
    free(counts);
}

static bool compute(Resource *sampler, const void *frame, Error *error) {
    const Resource *patches = sampler->inputs[0];
    float *light = memory_get(CELLS, 4 * sizeof *light),
          *direction = memory_get(CELLS, 4 * sizeof *direction);
    double *weights = memory_get(CELLS, sizeof *weights);
    (void)frame;
    bool ok = resource_read(patches, 0, light, error) && resource_read(patches, 1, direction, error);
    if (ok) {
        weigh(light, direction, weights);
        upload(sampler, weights);
    }
    free(light);
    free(direction);
    free(weights);
    return ok;
}

static bool wants_sampler(const void *frame) {
    const MethodChoice *light = ((const Frame *)frame)->light;
    return light && light->method->needs_sky_sampler;
}

static void sampler_uniforms(const Resource *sampler, const void *frame, Uniforms *uniforms) {
    static const double count[3] = {PATCH_COLUMNS, PATCH_ROWS_ABOVE, PATCH_ROWS_BELOW};
    (void)sampler;
    uniforms_declared_in(uniforms, "pass/sky_sampler.glsl");
    uniforms_vec3(uniforms, "sky_cells_count", count);
    uniforms_float(uniforms, "sky_cells_horizon",
                   sky_horizon_sine(&((const Frame *)frame)->state.atmosphere));
}

const ResourceKind sky_sampler = {.name = "the sky's sampler",
                                  .samplers = {"sky_bins", "sky_cell_share"},
                                  .filter = GL_NEAREST,
                                  .inputs = {&sky_patches},
                                  .wanted = wants_sampler,
                                  .compute = compute,
                                  .uniforms = sampler_uniforms};
