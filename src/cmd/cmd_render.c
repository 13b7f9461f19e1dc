#include "base/clock.h"
#include "choice/auto.h"
#include "cmd/cmd.h"
#include "cmd/interrupt.h"
#include "cmd/nan_map.h"
#include "cmd/outputs.h"
#include "cmd/render_job.h"
#include "cmd/render_toy.h"
#include "cmd/setup.h"
#include "error/noise_figures.h"
#include "image/format.h"
#include "render/chance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool check_outputs(const Options *options, Error *error) {
    if (!options->output_count)
        return error_set(error, STATUS_USAGE, "where to? (-o FILE.exr, .png or .pfm, or -o - --format png)");
    return outputs_check(options, error);
}

/* Checks the names of the layers, and that the picture's file format can hold them. */
static bool check_aov(const Options *options, unsigned *kinds, Error *error) {
    if (!aov_parse(options->aov, kinds, error)) return false;
    for (int i = 0; i < options->output_count; i++) {
        if (image_keeps_layers(options->outputs[i], outputs_format(options, i))) return true;
    }
    return !*kinds || error_set(error, STATUS_USAGE, "--aov: only .exr holds layers, and no -o names one");
}

/* What depends on a figure of the error has none with Markov chains. */
static bool check_sequence(const Options *options, unsigned aov_kinds, Error *error) {
    MethodChoice sequence;
    if (!method_choose(&sequence, METHOD_SEQUENCE, options->sequence, error)) return false;
    if (!sequence.method->walks_chains) return true;
    if (options->error.amount > 0 || !(options->samples || options->seconds > 0)) {
        return error_set(error, STATUS_USAGE,
                         "--sequence %s: its paths depend on each other, so that no error can be told or "
                         "promised; say how long by --spp N or --time SECONDS%s",
                         sequence.text, options->error.amount > 0 ? " in place of --error" : "");
    }
    return !(aov_kinds & AOV_VARIANCE) ||
           error_set(error, STATUS_USAGE,
                     "--aov variance: the paths of --sequence %s depend on each other, so that their "
                     "variance is not known; take another sequence, or leave this layer out",
                     sequence.text);
}

/* Fills the tables. If it is interrupted, no sample follows. */
static bool prepare_tables(RenderJob *job, Error *error) {
    double start = clock_seconds();
    while (job->renderer.prepared < 1 && !interrupt_requested()) {
        if (!renderer_prepare(&job->renderer, &job->params, 0.3, interrupt_requested, error)) return false;
        progress_prepare(&job->progress, job->renderer.prepared, clock_seconds() - start);
    }
    return true;
}

static Tone tone_of(const Options *options) {
    return options->tone && strcmp(options->tone, "none") == 0 ? TONE_NONE : TONE_AUTHOR;
}

static bool open_scene(RenderJob *job, Error *error) {
    const Options *options = job->options;
    return check_outputs(options, error) && setup_library(options, &job->library, error) &&
           setup_scene(options, job->library, &job->scene, error) &&
           (!options->width || scene_check_size(options->width, options->height, error));
}

static bool prepare(RenderJob *job, Error *error) {
    const Options *options = job->options;
    if (!check_aov(options, &job->aov_kinds, error) || !check_sequence(options, job->aov_kinds, error) ||
        !nan_map_check(options, error))
        return false;
    job->params = (RenderParams){.scene = &job->scene,
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
                                 .error_percent = target_percent(options->error, tone_of(options)),
                                 .variance = job->aov_kinds & AOV_VARIANCE,
                                 .rejects = options->nan_map != NULL,
                                 .in_steps = true};
    progress_begin(&job->progress, "compiling");
    return context_open(&job->context, options->backend, error) &&
           renderer_create(&job->renderer, &job->context, &job->params, error) &&
           prepare_tables(job, error) &&
           aov_create(&job->aov, job->aov_kinds, &job->context, &job->params, &job->renderer, error);
}

/* The error at which to stop, if there is one. */
static ErrorTarget target_of(const Options *options) {
    ErrorTarget none = {0}, usual = {.amount = AUTO_ERROR_PERCENT};
    if (options->error.amount > 0) return options->error;
    return options->samples || options->seconds > 0 ? none : usual;
}

double render_bias(const RenderJob *job, NoiseMeasure measure) {
    double slope = tone_levels_per_percent(tone_of(job->options));
    return job->renderer.sky_bias_percent * (measure == NOISE_LEVELS ? slope : 1);
}

/* The same, or 0 if it is not known. */
static double known_bias(const RenderJob *job, NoiseMeasure measure) {
    double bias = render_bias(job, measure);
    return isnan(bias) ? 0 : bias;
}

/* The noise with which noise and bias together reach the target error. A bias that alone exceeds the target,
 * which a sky of the user's choice may have, is left out. */
static double noise_left(double error, double bias) {
    return bias < error ? sqrt(error * error - bias * bias) : error;
}

static bool enough(const RenderJob *job) {
    const ProgressFigures *figures = &job->figures;
    if (figures->target_samples && figures->samples >= (double)figures->target_samples) return true;
    AdaptiveEnd end = adaptive_end(&job->adaptive);
    /* Where the time alone is limited, it ends before its time only if nothing can be added any more. */
    if (figures->target.amount > 0
            ? figures->noise[figures->target.measure] <= figures->target_noise || end != ADAPTIVE_GOES_ON
            : end == ADAPTIVE_FULL)
        return true;
    return figures->target_seconds > 0 && figures->seconds >= figures->target_seconds;
}

/* If only the time is limited, each group of samples aims at less error than there is. */
static bool sample(RenderJob *job, Error *error) {
    const ProgressFigures *figures = &job->figures;
    double noise = figures->target_noise;
    if (figures->target_samples)
        return adaptive_pass(&job->adaptive, &job->renderer, figures->target_samples, interrupt_requested,
                             error);
    if (!(noise > 0)) noise = 0.7 * figures->noise[figures->target.measure];
    return adaptive_round(&job->adaptive, &job->renderer, noise, interrupt_requested, error);
}

static bool read_picture(RenderJob *job, Error *error) {
    const Film *film = &job->renderer.film;
    if (!film_read(film, &job->image, &job->count, error) || !film_read_search(film, &job->search, error) ||
        !chance_read_shares(&job->chance, film, &job->image, error) ||
        !aov_read(&job->aov, film, &job->image, error)) {
        return false;
    }
    float *variance = aov_variance(&job->aov, &job->image);
    if (!variance) return true;
    noise_calibrate(&job->adaptive.noise, variance);
    for (size_t i = 0; i < 3 * (size_t)film->width * (size_t)film->height; i++)
        job->variance_unknown |= isnan(variance[i]);
    return true;
}

/* Sets the targets, and what is measured on the way. */
static void aim(RenderJob *job, double start) {
    const Options *options = job->options;
    ProgressFigures *figures = &job->figures;
    ErrorTarget target = target_of(options);
    ToneTable tone = tone_table(tone_of(options), exp2(job->scene.values.exposure_ev));
    job->adaptive =
        adaptive_create(&job->renderer, target.measure, target.measure == NOISE_LEVELS ? &tone : NULL);
    figures->target_samples = options->samples;
    figures->target_seconds = options->seconds;
    figures->target = target;
    figures->target_noise = noise_left(target.amount, known_bias(job, target.measure));
    for (int i = 0; i < NOISE_MEASURES; i++) figures->noise[i] = figures->error[i] = INFINITY;
    if (options->seconds > 0) job->adaptive.deadline = start + options->seconds;
}

static void note_errors(RenderJob *job) {
    for (NoiseMeasure i = 0; i < NOISE_MEASURES; i++) {
        job->figures.noise[i] = adaptive_error(&job->adaptive, i);
        job->figures.error[i] = hypot(job->figures.noise[i], known_bias(job, i));
    }
}

static void promise(RenderJob *job) {
    ProgressFigures *figures = &job->figures;
    NoiseMeasure measure = figures->target.measure;
    if (!(figures->target.amount > 0)) return;
    PromiseTerms terms = {.target = figures->target,
                          .reached = figures->noise[measure] <= figures->target_noise,
                          .bias = render_bias(job, measure),
                          .interrupted = figures->interrupted,
                          .facts = &job->scene.file->facts};
    job->promise = promise_judge(&job->adaptive, &terms);
    figures->promise = &job->promise;
}

static bool finish(RenderJob *job, Error *error) {
    ProgressFigures *figures = &job->figures;
    if (!read_picture(job, error)) return false;
    /* There are fewer than samples x pixels if it was stopped early. */
    figures->paths = job->count.accepted + job->count.rejected;
    figures->rejected = job->count.rejected;
    figures->light_rejected = job->count.light_rejected;
    figures->sun_by_chance = job->renderer.sun_by_chance || chance_matters(&job->chance);
    figures->chance = job->chance;
    figures->search_rays = job->search.rays;
    figures->search_steps = job->search.steps;
    figures->search_broken = job->search.broken;
    figures->search_cut = job->search.cut;
    figures->interrupted = interrupt_requested();
    figures->done = true;
    promise(job);
    progress_report(&job->progress, figures);
    return true;
}

static bool render(RenderJob *job, Error *error) {
    ProgressFigures *figures = &job->figures;
    double pixels = (double)job->renderer.film.width * job->renderer.film.height;
    double start = clock_seconds();
    aim(job, start);
    while (!enough(job) && !interrupt_requested()) {
        if (!sample(job, error)) return false;
        interrupt_keep();
        figures->paths = job->adaptive.paths;
        if (job->renderer.plan.sun.method->traces_light)
            figures->light_paths = job->renderer.film.light_paths;
        figures->samples = (double)figures->paths / pixels;
        if (!aov_pass(&job->aov, &job->renderer, (uint64_t)figures->samples, interrupt_requested, error))
            return false;
        note_errors(job);
        figures->seconds = clock_seconds() - start;
        if (!enough(job)) progress_report(&job->progress, figures);
    }
    return finish(job, error);
}

static bool write_outputs(const RenderJob *job, int argc, char **argv, Error *error) {
    const Options *options = job->options;
    AttributeList attributes = {0};
    render_describe(job, argc, argv, &attributes);
    ImageWriteParams params = {
        .exposure_ev = job->scene.values.exposure_ev, .tone = tone_of(options), .attributes = &attributes};
    bool ok = outputs_write(options, &job->image, &params, error) && nan_map_write(job, &attributes, error);
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

static bool render_scene(RenderJob *job, int argc, char **argv, Error *error) {
    double start = clock_seconds();
    bool ok = prepare(job, error);
    progress_clear(&job->progress);
    if (!ok) return false;
    job->figures.startup_seconds = clock_seconds() - start;
    if (job->options->verbose || job->options->files) render_say_choices(job);
    if (!render(job, error) || !write_outputs(job, argc, argv, error)) return false;
    if (!job->options->quiet) render_say_summary(job);
    fflush(stdout);
    /* The check compiles a program, which may take long: all is saved before it. */
    interrupt_saved();
    if (!job->figures.interrupted &&
        !check_scene(&job->check, &job->context, &job->params, &job->renderer, error))
        return false;
    render_warn(job);
    return true;
}

static double compile_seconds(const Options *options) {
    return options->compile_seconds > 0 ? options->compile_seconds : 60;
}

Status cmd_render(const Options *options, int argc, char **argv, Error *error) {
    RenderJob job = {.options = options, .progress = progress_start(options)};
    error->status = STATUS_DONE;
    interrupt_install();
    bool ok = open_scene(&job, error);
    if (ok) interrupt_limit_compiling(compile_seconds(options), job.scene.file->path);
    if (ok && render_is_toy(&job))
        ok = render_toy(&job, argc, argv, error);
    else
        ok = ok && render_scene(&job, argc, argv, error);
    progress_clear(&job.progress);
    bool interrupted = job.figures.interrupted;
    bool broken = options->error.amount > 0 && !job.promise.given;
    release(&job);
    if (!ok) return error->status;
    return interrupted ? STATUS_INTERRUPTED : broken ? STATUS_UNPROMISED : STATUS_DONE;
}
