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
    /* How the two files were read. */
    Text said[2];
    /* The pixels of the sun's image in either picture. */
    unsigned char *sun;
    Comparison result;
} CompareJob;

/* A line for each that is known of how a file was read. */
static void print_said(const char *file, const Text *said) {
    for (const char *line = text_string(said); *line;) {
        size_t length = strcspn(line, "\n");
        printf("read %s       %.*s\n", file, (int)length, line);
        line += length + (line[length] == '\n');
    }
}

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
    printf("pixels       %ld, %ld not finite", c->pixels, c->nonfinite);
    if (c->nonfinite) printf(", the first at %d,%d", c->nonfinite_x, c->nonfinite_y);
    printf("\n");
    if (c->outside) printf("outside      %ld left out, as a file's data window lacks them\n", c->outside);
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

/* The layer that was asked for; NULL stands for the picture itself, and so does an empty name. */
static const char *layer(const Options *options, int input) {
    const char *name = options->layer_count ? options->layers[options->layer_count > 1 ? input : 0] : NULL;
    return name && *name ? name : NULL;
}

static bool compare(CompareJob *job, const Options *options, Error *error) {
    ImageReadParams read_a = {.layer = layer(options, 0), .said = &job->said[0]};
    ImageReadParams read_b = {.layer = layer(options, 1), .said = &job->said[1]};
    bool none = options->tone && strcmp(options->tone, "none") == 0;
    CompareOptions how = {.tone = none ? TONE_NONE : TONE_AUTHOR};
    if (!image_read_as(&job->a, options->inputs[0], &read_a, error) ||
        !image_read_as(&job->b, options->inputs[1], &read_b, error) ||
        !read_optional(options->standard_error, &job->standard_error, error) ||
        !read_optional(options->mask, &job->mask, error) || !find_sun(job, options, error))
        return false;
    how.exposure_ev = exposure(options);
    how.sun = job->sun;
    if (options->standard_error) how.standard_error = &job->standard_error;
    if (options->mask) how.mask = &job->mask;
    return compare_images(&job->a, &job->b, &how, &job->result, error);
}

static void job_free(CompareJob *job) {
    image_free(&job->a);
    image_free(&job->b);
    image_free(&job->standard_error);
    image_free(&job->mask);
    text_free(&job->said[0]);
    text_free(&job->said[1]);
    free(job->sun);
}

static Status verdict(const Comparison *result, const Options *options, Error *error) {
    if (all_within(result, options)) return STATUS_DONE;
    if (result->nonfinite)
        error_set(error, STATUS_COMPARISON,
                  "%s differs from %s: %ld pixels are not finite, the first at %d,%d", options->inputs[0],
                  options->inputs[1], result->nonfinite, result->nonfinite_x, result->nonfinite_y);
    else
        error_set(error, STATUS_COMPARISON, "%s differs from %s by more than allowed", options->inputs[0],
                  options->inputs[1]);
    return STATUS_COMPARISON;
}

Status cmd_compare(const Options *options, Error *error) {
    CompareJob job = {0};
    bool ok = compare(&job, options, error);
    if (ok) {
        print_said("A", &job.said[0]);
        print_said("B", &job.said[1]);
        print_comparison(&job.result);
    }
    Status status = ok ? verdict(&job.result, options, error) : error->status;
    job_free(&job);
    return status;
}
