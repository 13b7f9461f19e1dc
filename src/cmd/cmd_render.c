#include "base/clock.h"
#include "base/file.h"
#include "base/version.h"
#include "choice/auto.h"
#include "cmd/cmd.h"
#include "cmd/interrupt.h"
#include "cmd/progress.h"
#include "cmd/setup.h"
#include "error/adaptive.h"
#include "image/format.h"
#include "render/aov.h"
#include "render/describe.h"
#include "render/renderer.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Job {
    const Options *options;
    char *library;
    Scene scene;
    Context context;
    Renderer renderer;
    Adaptive adaptive;
    unsigned aov_kinds;
    Aov aov;
    Image image;
    FilmCount count;
    FilmSearch search;
    bool variance_unknown; /* somewhere */
    ProgressFigures figures;
} Job;

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

/* Layers are asked for by name, and need a file that holds them. */
static bool check_aov(const Options *options, unsigned *kinds, Error *error) {
    if (!aov_parse(options->aov, kinds, error)) return false;
    for (int i = 0; i < options->output_count; i++) {
        if (image_keeps_layers(options->outputs[i])) return true;
    }
    return !*kinds || error_set(error, STATUS_USAGE, "--aov: only .exr holds layers, and no -o names one");
}

static bool prepare(Job *job, Error *error) {
    const Options *options = job->options;
    if (!check_outputs(options, error) || !check_aov(options, &job->aov_kinds, error) ||
        !setup_library(options, &job->library, error) || !setup_scene(options, &job->scene, error)) {
        return false;
    }
    if (options->width && !scene_check_size(options->width, options->height, error)) return false;
    RenderParams params = {.scene = &job->scene,
                           .library = job->library,
                           .sky = options->sky,
                           .light = options->light,
                           .sequence = options->sequence,
                           .sun_disk = options->sun_disk,
                           .width = options->width,
                           .height = options->height,
                           .seed = options->seed,
                           .max_hits = options->depth,
                           .samples = options->samples,
                           .error_percent = options->error_percent,
                           .variance = job->aov_kinds & AOV_VARIANCE};
    if (options->error_percent > 0 && options->samples) {
        return error_set(error, STATUS_USAGE,
                         "--error takes as many samples as it needs, --spp takes so many: one of them");
    }
    return context_open(&job->context, options->backend, error) &&
           renderer_create(&job->renderer, &job->context, &params, error) &&
           aov_create(&job->aov, job->aov_kinds, &job->context, &params, &job->renderer, error);
}

/* The error to stop at; 0 is none. */
static double wanted_error(const Options *options) {
    if (options->error_percent > 0) return options->error_percent;
    return options->samples || options->seconds > 0 ? 0 : AUTO_ERROR_PERCENT;
}

/* The sky's, as far as it is known. */
static double known_bias(const Job *job) {
    return isnan(job->renderer.sky_bias_percent) ? 0 : job->renderer.sky_bias_percent;
}

/* What noise may be for noise and bias to make up the error together. A bias that is more than the error
 * alone, of a sky that was asked for, stays out of it. */
static double noise_left(double percent, double bias) {
    return bias < percent ? sqrt(percent * percent - bias * bias) : percent;
}

static bool enough(const ProgressFigures *figures) {
    if (figures->target_samples && figures->samples >= (double)figures->target_samples) return true;
    if (figures->target_error_percent > 0 && figures->noise_percent <= figures->target_noise_percent)
        return true;
    return figures->target_seconds > 0 && figures->seconds >= figures->target_seconds;
}

/* Towards less error than there is by now, if time is all that limits. */
static bool sample(Job *job, Error *error) {
    const ProgressFigures *figures = &job->figures;
    double percent = figures->target_noise_percent;
    if (figures->target_samples)
        return adaptive_pass(&job->adaptive, &job->renderer, figures->target_samples, interrupt_requested,
                             error);
    if (!(percent > 0)) percent = 0.7 * figures->noise_percent;
    return adaptive_round(&job->adaptive, &job->renderer, percent, interrupt_requested, error);
}

static bool read_picture(Job *job, Error *error) {
    const Film *film = &job->renderer.film;
    if (!film_read(film, &job->image, &job->count, error) || !film_read_search(film, &job->search, error) ||
        !aov_read(&job->aov, film, &job->image, error)) {
        return false;
    }
    for (int i = 0; i < job->image.layer_count; i++) {
        if (strcmp(job->image.layers[i].name, "variance") != 0) continue;
        float *variance = job->image.layers[i].data;
        noise_calibrate(&job->adaptive.noise, variance);
        for (size_t k = 0; k < 3 * (size_t)film->width * (size_t)film->height; k++)
            job->variance_unknown |= isnan(variance[k]);
    }
    return true;
}

static bool render(Job *job, Error *error) {
    const Options *options = job->options;
    ProgressFigures *figures = &job->figures;
    Progress progress = progress_start(options);
    double pixels = (double)job->renderer.film.width * job->renderer.film.height;
    double bias = known_bias(job), start = clock_seconds();
    job->adaptive = adaptive_create(&job->renderer, job->renderer.sun.rectangle_count ? NOISE_SUN_TRIM : 0);
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
        progress_report(&progress, figures);
    }
    if (!read_picture(job, error)) return false;
    figures->paths =
        job->count.accepted + job->count.rejected; /* fewer than samples x pixels if stopped early */
    figures->rejected = job->count.rejected;
    figures->sun_by_chance = job->renderer.sun_by_chance;
    figures->search_rays = job->search.rays;
    figures->search_steps = job->search.steps;
    figures->search_broken = job->search.broken;
    figures->search_cut = job->search.cut;
    figures->interrupted = interrupt_requested();
    figures->done = true;
    progress_report(&progress, figures);
    return true;
}

/* The metadata: enough to make the picture again. */
static void describe(const Job *job, int argc, char **argv, AttributeList *list) {
    Text command = {0};
    text_print_command(&command, argc, argv);
    attribute_add(list, "magichour.version", "%s", MAGICHOUR_VERSION);
    attribute_add(list, "magichour.command", "%s", text_string(&command));
    if (job->options->aov) attribute_add(list, "magichour.aov", "%s", job->options->aov);
    attribute_add(list, "magichour.depth", "%d", job->options->depth);
    attribute_add(list, "magichour.samples", "%.6g", job->figures.samples);
    attribute_add(list, "magichour.samples_range", "%" PRIu64 " to %" PRIu64, job->adaptive.least,
                  job->adaptive.most);
    if (job->renderer.sun_by_chance) attribute_add(list, "magichour.sun_by_chance", "true");
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

static bool write_outputs(const Job *job, int argc, char **argv, Error *error) {
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

static void say_why(const char *what, const MethodChoice *choice) {
    if (choice->why[0]) fprintf(stderr, "auto took %s %s: %s\n", what, choice->text, choice->why);
}

static void say_choices(const Job *job) {
    const Renderer *renderer = &job->renderer;
    fprintf(stderr, "backend %s (%s): %s, OpenGL %s\n", job->context.backend->name, job->context.detail,
            job->context.renderer, job->context.version);
    fprintf(stderr, "sky %s, sun disk %s, light %s, sequence %s, at most %d hits, groups of %u samples\n",
            renderer->sky.choice.text, renderer->sun_disk.text, renderer->light.text, renderer->sequence.text,
            renderer->max_hits, renderer->group_samples);
    say_why("sky", &renderer->sky.choice);
    say_why("light", &renderer->light);
    if (renderer->sky.choice.table) {
        fprintf(stderr, "the sky's table: twice %dx%d directions, above the horizon and below\n",
                renderer->sky.columns, renderer->sky.rows);
    }
    fprintf(stderr, "compiled: %s\n", text_string(&renderer->source_files));
}

/* What the picture errs, and in what. */
static void say_error(const Job *job) {
    const ProgressFigures *figures = &job->figures;
    double bias = job->renderer.sky_bias_percent;
    if (figures->error_percent < INFINITY) {
        printf("; estimated error %.3g %%%s: noise %.3g %%", figures->error_percent,
               job->adaptive.noise.trim > 0 ? " without the 0.1 % worst pixels" : "", figures->noise_percent);
    }
    if (isnan(bias))
        printf("; the sky's bias is not known here");
    else if (bias > 0)
        printf("%s sky %.2g %% at most", figures->error_percent < INFINITY ? "," : ";", bias);
    if (job->options->depth) printf("; without what --depth cuts");
    if (bias > figures->target_error_percent && figures->target_error_percent > 0)
        printf("; such a sky errs more than was asked for");
}

static void say_summary(const Job *job) {
    const ProgressFigures *figures = &job->figures;
    const Adaptive *adaptive = &job->adaptive;
    for (int i = 0; i < job->options->output_count; i++)
        printf("%s%s", i ? ", " : "", job->options->outputs[i]);
    printf(": %.4g samples", figures->samples);
    if (adaptive->most > adaptive->least)
        printf(" (%" PRIu64 " to %" PRIu64 ")", adaptive->least, adaptive->most);
    printf(", %.4g Mpaths in %.2f s, %.2f Mpaths/s (and %.2f s to start)", 1e-6 * (double)figures->paths,
           figures->seconds, 1e-6 * (double)figures->paths / fmax(figures->seconds, 1e-9),
           figures->startup_seconds);
    say_error(job);
    printf("\n");
}

static void warn_search(const Job *job) {
    const FilmSearch *search = &job->search;
    const char *path = job->scene.file->path;
    if (job->options->verbose && search->rays > 0) {
        fprintf(stderr, "searches: %.4g rays, %.1f steps each, %.0f cut\n", search->rays,
                search->steps / search->rays, search->cut);
    }
    if (search->broken > 0) {
        fprintf(stderr,
                "magichour: warning: %s: %.2g %% of the rays that marched met a field that changes faster "
                "than the distance, or is no number: "
                "there may be holes; divide scene_distance() by its largest slope\n",
                path, 100 * search->broken / search->rays);
    }
    if (search->cut > 1e-6 * search->rays) {
        fprintf(stderr,
                "magichour: warning: %s: %.2g %% of the rays that searched were cut after as many steps as "
                "they may take: they may "
                "have missed something thin\n",
                path, 100 * search->cut / search->rays);
    }
}

static void warn(const Job *job) {
    if (job->variance_unknown) {
        fprintf(stderr,
                "magichour: warning: --aov variance is not known from %u samples or fewer: there it is NaN\n",
                job->renderer.group_samples);
    }
    if (job->figures.rejected) {
        fprintf(stderr,
                "magichour: warning: %" PRIu64 " of %" PRIu64 " samples were not finite%s and are left out\n",
                job->figures.rejected, job->figures.paths,
                job->search.rays > 0 ? ", or took more loops than the driver allows," : "");
    }
    if (job->renderer.sun_by_chance) {
        fprintf(
            stderr,
            "magichour: warning: %s: sunlight that glass throws, or mirrors that the scene does not name, "
            "is found by chance: "
            "the estimated error knows nothing of what no sample has met\n",
            job->scene.file->path);
    }
    warn_search(job);
}

static void release(Job *job) {
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
    Job job = {.options = options};
    error->status = STATUS_DONE;
    interrupt_install();
    bool ok = prepare(&job, error);
    if (ok) {
        job.figures.startup_seconds = clock_seconds() - start;
        if (options->verbose) say_choices(&job);
        ok = render(&job, error) && write_outputs(&job, argc, argv, error);
    }
    if (ok) {
        if (!options->quiet) say_summary(&job);
        warn(&job);
    }
    bool interrupted = job.figures.interrupted;
    release(&job);
    if (!ok) return error->status;
    return interrupted ? STATUS_INTERRUPTED : STATUS_DONE;
}
