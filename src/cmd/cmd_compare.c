#include "base/descriptor.h"
#include "base/memory.h"
#include "base/number.h"
#include "cmd/cmd.h"
#include "cmd/compare_print.h"
#include "cmd/option_values.h"
#include "cmd/outputs.h"
#include "image/difference.h"
#include "image/format.h"
#include "image/sun_pixels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct CompareJob {
    Image a, b, standard_error, mask;
    /* The bytes of both files, for their metadata. */
    Text a_bytes, b_bytes;
    CompareSaid said;
    /* The pixels of the sun's image in either picture. */
    unsigned char *sun;
    /* The pixels that are compared. */
    unsigned char *compared;
    CompareOptions how;
    Comparison result;
} CompareJob;

/* NaN exceeds every bound. */
static bool within(double value, double bound) {
    return isinf(bound) || fabs(value) <= bound;
}

static bool bounds_radiance(const Options *options) {
    return !isinf(options->max_relrmse_percent) || !isinf(options->max_bias_percent);
}

static bool all_within(const Comparison *c, const Options *options) {
    bool inside = within(c->rel_rmse_percent, options->max_relrmse_percent) &&
                  within(c->levels.rms, options->max_levels);
    for (int i = 0; i < 3; i++) inside = inside && within(c->bias_percent[i], options->max_bias_percent);
    /* A bound is a promise about every pixel that is compared. A pixel that is not finite breaks it. */
    bool bounded = bounds_radiance(options) || !isinf(options->max_levels);
    return inside && !(bounded && c->nonfinite);
}

/* Marks the pixels of the sun's image that the picture's metadata name. */
static bool mark_sun(CompareJob *job, const Text *bytes, const char *path, Error *error) {
    Text text = {0};
    bool ok = !image_attribute(bytes, SUN_PIXELS_ATTRIBUTE, &text) ||
              sun_pixels_parse(text_string(&text), job->sun, job->b.width, job->b.height, error) ||
              error_prefix(error, "%s: ", path);
    text_free(&text);
    return ok;
}

static bool find_sun(CompareJob *job, const Options *options, Error *error) {
    /* Pictures of other sizes have other pixels; the comparison refuses them. */
    if (options->with_sun || job->a.width != job->b.width || job->a.height != job->b.height) return true;
    job->sun = memory_get((size_t)job->b.width * (size_t)job->b.height, 1);
    return mark_sun(job, &job->a_bytes, options->inputs[0], error) &&
           mark_sun(job, &job->b_bytes, options->inputs[1], error);
}

/* The exposure that was asked for, or else that of a metadata: of A if only A is shown already, or else of B.
 */
static double exposure(const CompareJob *job, const Options *options) {
    if (options->has_exposure) return options->exposure_ev;
    Text text = {0};
    double exposure_ev = 0;
    const Text *bytes = job->a.shown && !job->b.shown ? &job->a_bytes : &job->b_bytes;
    if (!image_attribute(bytes, "magichour.exposure", &text) ||
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

static bool read_optional(const char *path, Image *image, Error *error) {
    return !path || image_read(image, path, error);
}

static bool pictures_read(CompareJob *job, const Options *options, Error *error) {
    ImageReadParams read_a = {.layer = layer(options, 0), .said = &job->said.a, .bytes = &job->a_bytes};
    ImageReadParams read_b = {.layer = layer(options, 1), .said = &job->said.b, .bytes = &job->b_bytes};
    if (!image_read_as(&job->a, options->inputs[0], &read_a, error) ||
        !image_read_as(&job->b, options->inputs[1], &read_b, error) ||
        !read_optional(options->standard_error, &job->standard_error, error) ||
        !read_optional(options->mask, &job->mask, error))
        return false;
    if (!job->a.shown && !job->b.shown) return true;
    if (!bounds_radiance(options) && !options->standard_error) return true;
    return error_set(
        error, STATUS_USAGE,
        "%s: a PNG holds no radiance: only --max-levels can bound the difference, and --se has no use",
        options->inputs[job->a.shown ? 0 : 1]);
}

static bool compare(CompareJob *job, const Options *options, Error *error) {
    if (!pictures_read(job, options, error) || !find_sun(job, options, error)) return false;
    bool none = options->tone && strcmp(options->tone, "none") == 0;
    job->compared = memory_get((size_t)job->b.width * (size_t)job->b.height, 1);
    job->how = (CompareOptions){.tone = none ? TONE_NONE : TONE_AUTHOR,
                                .exposure_ev = exposure(job, options),
                                .sun = job->sun,
                                .compared = job->compared,
                                .standard_error = options->standard_error ? &job->standard_error : NULL,
                                .mask = options->mask ? &job->mask : NULL};
    return compare_images(&job->a, &job->b, &job->how, &job->result, error);
}

static bool write_picture(Image image, const char *path, Error *error) {
    bool written = image_write(&image, path, &(ImageWriteParams){.format = "png"}, error);
    image_free(&image);
    return written;
}

static bool pictures_write(const CompareJob *job, const Options *options, Error *error) {
    DifferenceParams params = {.a = &job->a,
                               .b = &job->b,
                               .compared = job->compared,
                               .tone = job->how.tone,
                               .exposure_ev = job->how.exposure_ev};
    for (int i = 0; i < options->output_count; i++) {
        if (!write_picture(difference_picture(&params), options->outputs[i], error)) return false;
    }
    return !options->side_by_side ||
           write_picture(difference_side_by_side(&params), options->side_by_side, error);
}

/* False colours are no radiance. */
static bool path_check(const char *path, const char *format, Error *error) {
    const char *dot = strrchr(path, '.');
    bool png = format ? strcmp(format, "png") == 0
                      : descriptor_of(path) >= 0 || (dot && strcasecmp(dot, ".png") == 0);
    if (png) return image_check_target(path, "png", error);
    return error_set(error, STATUS_USAGE, "%s: false colours can only be written as .png", path);
}

/* Checks where the pictures go. Standard output takes one, and then no figures. */
static bool paths_check(const Options *options, Error *error) {
    Options pictures = *options;
    if (options->side_by_side && !take_output(&pictures, "-o", options->side_by_side, error)) return false;
    for (int i = 0; i < pictures.output_count; i++) {
        if (!path_check(pictures.outputs[i], outputs_format(&pictures, i), error)) return false;
    }
    pictures.format = "png";
    return outputs_check(&pictures, error);
}

/* Standard input can be read once. */
static bool inputs_check(const Options *options, Error *error) {
    const char *const paths[] = {options->inputs[0], options->inputs[1], options->standard_error,
                                 options->mask};
    int count = 0;
    for (int i = 0; i < 4; i++) count += paths[i] && strcmp(paths[i], "-") == 0;
    return count < 2 || error_set(error, STATUS_USAGE, "-: standard input holds one picture");
}

/* With --quiet, the exit status says it all. */
static Status verdict(const Comparison *result, const Options *options, Error *error) {
    if (all_within(result, options)) return STATUS_DONE;
    if (options->quiet) return STATUS_COMPARISON;
    if (result->nonfinite)
        error_set(error, STATUS_COMPARISON,
                  "%s differs from %s: %ld pixels are not finite, the first at %d,%d", options->inputs[0],
                  options->inputs[1], result->nonfinite, result->nonfinite_x, result->nonfinite_y);
    else
        error_set(error, STATUS_COMPARISON, "%s differs from %s by more than allowed", options->inputs[0],
                  options->inputs[1]);
    return STATUS_COMPARISON;
}

static void job_free(CompareJob *job) {
    image_free(&job->a);
    image_free(&job->b);
    image_free(&job->standard_error);
    image_free(&job->mask);
    text_free(&job->a_bytes);
    text_free(&job->b_bytes);
    text_free(&job->said.a);
    text_free(&job->said.b);
    free(job->sun);
    free(job->compared);
}

Status cmd_compare(const Options *options, Error *error) {
    CompareJob job = {0};
    Status status;
    if (inputs_check(options, error) && paths_check(options, error) && compare(&job, options, error) &&
        pictures_write(&job, options, error)) {
        if (!options->quiet && options->json)
            compare_print_json(&job.result, &job.said, all_within(&job.result, options));
        else if (!options->quiet)
            compare_print(&job.result, &job.said);
        status = verdict(&job.result, options, error);
    } else {
        status = error->status;
    }
    job_free(&job);
    return status;
}
