#include "base/memory.h"
#include "base/number.h"
#include "cmd/cmd.h"
#include "image/compare.h"
#include "image/exr_attribute.h"
#include "image/format.h"
#include "image/sun_pixels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct CompareJob {
    Image a, b, standard_error, mask;
    /* The pixels of the sun's image in either picture. */
    unsigned char *sun;
    Comparison result;
} CompareJob;

static void print_comparison(const Comparison *c) {
    const Levels *levels = &c->levels;
    printf("relRMSE      %.4f %%\n", c->rel_rmse_percent);
    printf("  trimmed    %.4f %%  (without the 0.1 %% worst pixels, in the mean too)\n", c->trimmed_percent);
    printf("bias R G B   %+.4f %+.4f %+.4f %%\n", c->bias_percent[0], c->bias_percent[1], c->bias_percent[2]);
    printf("largest      %.4f %%\n", c->largest_percent);
    printf("p99          %.4f %%\n", c->p99_percent);
    printf("levels RMS   %.4f of 255\n", levels->rms);
    printf("  worst tile %.4f of 255, %dx%d pixels at %d,%d\n", levels->worst_tile, LEVELS_TILE, LEVELS_TILE,
           levels->worst_x, levels->worst_y);
    printf("pixels       %ld, %ld not finite\n", c->pixels, c->nonfinite);
    printf("sun pixels   %ld left out\n", c->sun_pixels);
    if (c->has_z) printf("mean z^2     %.4f, |z| > 4 in %.4f %%\n", c->mean_z2, c->share_z4_percent);
}

/* NaN exceeds every bound. */
static bool within(double value, double bound) {
    return isinf(bound) || fabs(value) <= bound;
}

static bool all_within(const Comparison *c, const Options *options) {
    bool inside = within(c->rel_rmse_percent, options->max_relrmse_percent) &&
                  within(c->levels.rms, options->max_levels);
    for (int i = 0; i < 3; i++) inside = inside && within(c->bias_percent[i], options->max_bias_percent);
    /* A bound is a promise about every pixel that is compared. A pixel that is not finite breaks it. */
    bool bounded = !isinf(options->max_relrmse_percent) || !isinf(options->max_bias_percent) ||
                   !isinf(options->max_levels);
    return inside && !(bounded && c->nonfinite);
}

static bool read_optional(const char *path, Image *image, Error *error) {
    return !path || image_read(image, path, error);
}

/* Marks the pixels of the sun's image that the picture's metadata name. */
static bool mark_sun(CompareJob *job, const char *path, Error *error) {
    Text text = {0};
    bool ok = !exr_attribute(path, SUN_PIXELS_ATTRIBUTE, &text) ||
              sun_pixels_parse(text_string(&text), job->sun, job->b.width, job->b.height, error) ||
              error_prefix(error, "%s: ", path);
    text_free(&text);
    return ok;
}

static bool find_sun(CompareJob *job, const Options *options, Error *error) {
    /* Pictures of other sizes have other pixels; the comparison refuses them. */
    if (options->with_sun || job->a.width != job->b.width || job->a.height != job->b.height) return true;
    job->sun = memory_get((size_t)job->b.width * (size_t)job->b.height, 1);
    return mark_sun(job, options->inputs[0], error) && mark_sun(job, options->inputs[1], error);
}

/* The exposure that was asked for, or else that of the reference's metadata, or else 0. */
static double exposure(const Options *options) {
    Text text = {0};
    double exposure_ev = options->exposure_ev;
    if (!options->has_exposure && exr_attribute(options->inputs[1], "magichour.exposure", &text) &&
        !number_parse(text_string(&text), &exposure_ev))
        exposure_ev = 0;
    text_free(&text);
    return exposure_ev;
}

static bool compare(CompareJob *job, const Options *options, Error *error) {
    bool none = options->tone && strcmp(options->tone, "none") == 0;
    CompareOptions how = {.tone = none ? TONE_NONE : TONE_AUTHOR};
    if (!image_read(&job->a, options->inputs[0], error) || !image_read(&job->b, options->inputs[1], error) ||
        !read_optional(options->standard_error, &job->standard_error, error) ||
        !read_optional(options->mask, &job->mask, error) || !find_sun(job, options, error))
        return false;
    how.exposure_ev = exposure(options);
    how.sun = job->sun;
    if (options->standard_error) how.standard_error = &job->standard_error;
    if (options->mask) how.mask = &job->mask;
    return compare_images(&job->a, &job->b, &how, &job->result, error);
}

Status cmd_compare(const Options *options, Error *error) {
    CompareJob job = {0};
    bool ok = compare(&job, options, error);
    image_free(&job.a);
    image_free(&job.b);
    image_free(&job.standard_error);
    image_free(&job.mask);
    free(job.sun);
    if (!ok) return error->status;
    print_comparison(&job.result);
    if (all_within(&job.result, options)) return STATUS_DONE;
    error_set(error, STATUS_COMPARISON, "%s differs from %s by more than allowed", options->inputs[0],
              options->inputs[1]);
    return STATUS_COMPARISON;
}
