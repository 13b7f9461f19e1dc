#include "base/clock.h"
#include "base/file.h"
#include "base/version.h"
#include "choice/auto.h"
#include "cmd/cmd.h"
#include "cmd/interrupt.h"
#include "cmd/render_job.h"
#include "cmd/setup.h"
#include "image/format.h"
#include "render/chance.h"
#include "render/describe.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool check_outputs(const Options *options, Error *error) {
    if (!options->output_count)
        return error_set(error, STATUS_USAGE, "where to? (-o FILE.exr, .png or .pfm)");
    for (int i = 0; i < options->output_count; i++) {
        if (!image_check_path(options->outputs[i], error)) return false;
    }
    for (int i = 0; i < options->output_count; i++) {
        if (!file_check_target(options->outputs[i], error)) return false;
    }
    return true;
}

/* Checks the names of the layers, and that the picture's file format can hold them. */
static bool check_aov(const Options *options, unsigned *kinds, Error *error) {
    if (!aov_parse(options->aov, kinds, error)) return false;
    for (int i = 0; i < options->output_count; i++) {
        if (image_keeps_layers(options->outputs[i])) return true;
    }
    return !*kinds || error_set(error, STATUS_USAGE, "--aov: only .exr holds layers, and no -o names one");
}

/* Fills the tables. If it is interrupted, no sample follows. */
static bool prepare_tables(RenderJob *job, const RenderParams *params, Error *error) {
    double start = clock_seconds();
    while (job->renderer.prepared < 1 && !interrupt_requested()) {
        if (!renderer_prepare(&job->renderer, params, 0.3, interrupt_requested, error)) return false;
        progress_prepare(&job->progress, job->renderer.prepared, clock_seconds() - start);
    }
    return true;
}

static bool prepare(RenderJob *job, Error *error) {
    const Options *options = job->options;
    if (!check_outputs(options, error) || !check_aov(options, &job->aov_kinds, error) ||
        !setup_library(options, &job->library, error) ||
        !setup_scene(options, job->library, &job->scene, error)) {
        return false;
    }
    if (options->width && !scene_check_size(options->width, options->height, error)) return false;
    RenderParams params = {.scene = &job->scene,
                           .sky = options->sky,
                           .light = options->light,
                           .sequence = options->sequence,
                           .further = options->further,
                           .sun_disk = options->sun_disk,
                           .width = options->width,
                           .height = options->height,
                           .seed = options->seed,
                           .max_hits = options->depth,
                           .samples = options->samples,
                           .error_percent = options->error_percent,
                           .variance = job->aov_kinds & AOV_VARIANCE,
                           .in_steps = true};
    if (options->error_percent > 0 && options->samples) {
        return error_set(error, STATUS_USAGE,
                         "--error takes as many samples as it needs, --spp takes so many: one of them");
    }
    return context_open(&job->context, options->backend, error) &&
           renderer_create(&job->renderer, &job->context, &params, error) &&
           prepare_tables(job, &params, error) &&
           aov_create(&job->aov, job->aov_kinds, &job->context, &params, &job->renderer, error);
}

/* The error at which to stop; 0 if there is none. */
static double wanted_error(const Options *options) {
    if (options->error_percent > 0) return options->error_percent;
    return options->samples || options->seconds > 0 ? 0 : AUTO_ERROR_PERCENT;
}

/* The sky's bias, or 0 if it is not known. */
static double known_bias(const RenderJob *job) {
    return isnan(job->renderer.sky_bias_percent) ? 0 : job->renderer.sky_bias_percent;
}

/* The noise with which noise and bias together reach the target error. A bias that alone exceeds the target,
 * which a sky of the user's choice may have, is left out. */
static double noise_left(double percent, double bias) {
    return bias < percent ? sqrt(percent * percent - bias * bias) : percent;
}

static bool enough(const ProgressFigures *figures) {
    if (figures->target_samples && figures->samples >= (double)figures->target_samples) return true;
    if (figures->target_error_percent > 0 && figures->noise_percent <= figures->target_noise_percent)
        return true;
    return figures->target_seconds > 0 && figures->seconds >= figures->target_seconds;
}

/* If only the time is limited, each group of samples aims at less error than there is. */
static bool sample(RenderJob *job, Error *error) {
    const ProgressFigures *figures = &job->figures;
    double percent = figures->target_noise_percent;
    if (figures->target_samples)
        return adaptive_pass(&job->adaptive, &job->renderer, figures->target_samples, interrupt_requested,
                             error);
    if (!(percent > 0)) percent = 0.7 * figures->noise_percent;
    return adaptive_round(&job->adaptive, &job->renderer, percent, interrupt_requested, error);
}

static bool read_picture(RenderJob *job, Error *error) {
    const Film *film = &job->renderer.film;
    if (!film_read(film, &job->image, &job->count, error) || !film_read_search(film, &job->search, error) ||
        !film_read_chance(film, &job->chance, error) || !aov_read(&job->aov, film, &job->image, error)) {
        return false;
    }
    float *variance = aov_variance(&job->aov, &job->image);
    if (!variance) return true;
    noise_calibrate(&job->adaptive.noise, variance);
    for (size_t i = 0; i < 3 * (size_t)film->width * (size_t)film->height; i++)
        job->variance_unknown |= isnan(variance[i]);
    return true;
}

static bool render(RenderJob *job, Error *error) {
    const Options *options = job->options;
    ProgressFigures *figures = &job->figures;
    double pixels = (double)job->renderer.film.width * job->renderer.film.height;
    double bias = known_bias(job), start = clock_seconds();
    job->adaptive = adaptive_create(&job->renderer, job->renderer.image.where.count ? NOISE_SUN_TRIM : 0);
    figures->target_samples = options->samples;
    figures->target_seconds = options->seconds;
    figures->target_error_percent = wanted_error(options);
    figures->noise_percent = figures->error_percent = INFINITY;
    figures->target_noise_percent = noise_left(figures->target_error_percent, bias);
    if (options->seconds > 0) job->adaptive.deadline = start + options->seconds;
    while (!enough(figures) && !interrupt_requested()) {
        if (!sample(job, error)) return false;
        figures->paths = job->adaptive.paths;
        figures->samples = (double)figures->paths / pixels;
        if (!aov_pass(&job->aov, &job->renderer, (uint64_t)figures->samples, interrupt_requested, error))
            return false;
        figures->noise_percent = adaptive_percent(&job->adaptive);
        figures->error_percent = hypot(figures->noise_percent, bias);
        figures->seconds = clock_seconds() - start;
        progress_report(&job->progress, figures);
    }
    if (!read_picture(job, error)) return false;
    /* There are fewer than samples x pixels if it was stopped early. */
    figures->paths = job->count.accepted + job->count.rejected;
    figures->rejected = job->count.rejected;
    figures->sun_by_chance = job->renderer.sun_by_chance || chance_matters(&job->chance);
    figures->chance = job->chance;
    figures->search_rays = job->search.rays;
    figures->search_steps = job->search.steps;
    figures->search_broken = job->search.broken;
    figures->search_cut = job->search.cut;
    figures->interrupted = interrupt_requested();
    figures->done = true;
    progress_report(&job->progress, figures);
    return true;
}

/* Adds the metadata from which the picture can be made again. */
static void describe(const RenderJob *job, int argc, char **argv, AttributeList *list) {
    Text command = {0};
    text_print_command(&command, argc, argv);
    attribute_add(list, "magichour.version", "%s", MAGICHOUR_VERSION);
    attribute_add(list, "magichour.command", "%s", text_string(&command));
    if (job->options->aov) attribute_add(list, "magichour.aov", "%s", job->options->aov);
    attribute_add(list, "magichour.depth", "%d", job->options->depth);
    attribute_add(list, "magichour.samples", "%.6g", job->figures.samples);
    attribute_add(list, "magichour.samples_range", "%" PRIu64 " to %" PRIu64, job->adaptive.least,
                  job->adaptive.most);
    if (job->figures.sun_by_chance) attribute_add(list, "magichour.sun_by_chance", "true");
    if (job->chance.paths > 0) {
        attribute_add(list, "magichour.chance_paths_percent", "%.3g", 100 * job->chance.paths);
        attribute_add(list, "magichour.chance_pixels_percent", "%.3g", 100 * job->chance.pixels);
        attribute_add(list, "magichour.chance_light_percent", "%.3g", 100 * job->chance.light);
    }
    if (job->figures.error_percent < INFINITY) {
        attribute_add(list, "magichour.error_percent", "%.4g", job->figures.error_percent);
        attribute_add(list, "magichour.noise_percent", "%.4g", job->figures.noise_percent);
    }
    attribute_add(list, "magichour.rejected", "%" PRIu64, job->count.rejected);
    if (job->search.rays > 0) {
        attribute_add(list, "magichour.searches",
                      "%.0f rays, %.2f steps each, %.0f in a field that is no distance, %.0f cut",
                      job->search.rays, job->search.steps / job->search.rays, job->search.broken,
                      job->search.cut);
    }
    attribute_add(list, "magichour.seconds", "%.6f", job->figures.seconds);
    describe_picture(list, &job->scene, &job->renderer, &job->context);
    text_free(&command);
}

static bool write_outputs(const RenderJob *job, int argc, char **argv, Error *error) {
    const Options *options = job->options;
    AttributeList attributes = {0};
    bool ok = true;
    describe(job, argc, argv, &attributes);
    ImageWriteParams params = {.exposure_ev = job->scene.values.exposure_ev,
                               .tone = options->tone && strcmp(options->tone, "none") == 0 ? TONE_NONE
                                                                                           : TONE_AUTHOR,
                               .attributes = &attributes};
    for (int i = 0; ok && i < options->output_count; i++) {
        ok = image_write(&job->image, options->outputs[i], &params, error);
    }
    attribute_list_free(&attributes);
    return ok;
}

static void release(RenderJob *job) {
    image_free(&job->image);
    aov_destroy(&job->aov);
    adaptive_destroy(&job->adaptive);
    renderer_destroy(&job->renderer);
    context_close(&job->context);
    scene_destroy(&job->scene);
    free(job->library);
}

Status cmd_render(const Options *options, int argc, char **argv, Error *error) {
    double start = clock_seconds();
    RenderJob job = {.options = options, .progress = progress_start(options)};
    error->status = STATUS_DONE;
    interrupt_install();
    bool ok = prepare(&job, error);
    if (ok) {
        job.figures.startup_seconds = clock_seconds() - start;
        if (options->verbose) render_say_choices(&job);
        ok = render(&job, error) && write_outputs(&job, argc, argv, error);
    }
    if (ok) {
        if (!options->quiet) render_say_summary(&job);
        render_warn(&job);
    }
    bool interrupted = job.figures.interrupted;
    release(&job);
    if (!ok) return error->status;
    return interrupted ? STATUS_INTERRUPTED : STATUS_DONE;
}
