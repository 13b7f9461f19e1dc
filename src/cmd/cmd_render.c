#include "base/clock.h"
#include "choice/auto.h"
#include "cmd/cmd.h"
#include "cmd/interrupt.h"
#include "cmd/nan_map.h"
#include "cmd/outputs.h"
#include "cmd/render_job.h"
#include "cmd/render_run.h"
#include "cmd/render_toy.h"
#include "cmd/render_write.h"
#include "cmd/saver.h"
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
    if (render_is_part(options))
        return error_set(
            error, STATUS_USAGE,
            "--sequence %s: its paths have no numbers, and fall on all pixels: --first-sample and "
            "--crop are for other sequences",
            sequence.text);
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

static bool open_scene(RenderJob *job, Error *error) {
    const Options *options = job->options;
    return check_outputs(options, error) && saver_check(options, error) &&
           setup_library(options, &job->library, error) &&
           setup_scene(options, job->library, &job->scene, error) &&
           (!options->width || scene_check_size(options->width, options->height, error));
}

/* What parts of a picture can be: of a picture whose samples have numbers, and these pixels of it. */
static bool check_part(const RenderJob *job, Error *error) {
    const Options *options = job->options;
    const Rectangle *crop = &options->crop;
    int width = options->width ? options->width : job->scene.file->width,
        height = options->width ? options->height : job->scene.file->height;
    uint64_t lap = (uint64_t)1 << 32, most = options->samples ? options->samples : ADAPTIVE_MOST_SAMPLES * 8;
    if (options->first_sample % lap + most > lap)
        return error_set(
            error, STATUS_USAGE,
            "--first-sample %llu: samples have numbers of 32 bits, and a part may not go past sample "
            "%llu: end it there by --spp, and begin another part",
            options->first_sample, (unsigned long long)((options->first_sample / lap + 1) * lap - 1));
    if (crop->x + crop->width > width || crop->y + crop->height > height)
        return error_set(error, STATUS_USAGE, "--crop %d,%d,%d,%d: the picture has %dx%d pixels", crop->x,
                         crop->y, crop->width, crop->height, width, height);
    return true;
}

static bool prepare(RenderJob *job, Error *error) {
    const Options *options = job->options;
    if (!check_part(job, error)) return false;
    if (!check_aov(options, &job->aov_kinds, error) || !check_sequence(options, job->aov_kinds, error) ||
        !nan_map_check(options, error))
        return false;
    job->params = setup_params(options, &job->scene);
    job->params.first_sample = options->first_sample;
    job->params.crop = options->crop;
    job->params.samples = options->of        ? options->of
                          : options->samples ? options->first_sample + options->samples
                                             : 0;
    job->params.error_percent = target_percent(options->error, render_tone(options));
    job->params.variance = job->aov_kinds & AOV_VARIANCE;
    job->params.rejects = options->nan_map != NULL;
    job->params.in_steps = true;
    saver_recall(job);
    progress_begin(&job->progress, "compiling");
    return context_open(&job->context, options->backend, error) &&
           renderer_create(&job->renderer, &job->context, &job->params, error) &&
           prepare_tables(job, error) &&
           aov_create(&job->aov, job->aov_kinds, &job->context, &job->params, &job->renderer, error);
}

static void release(RenderJob *job) {
    image_free(&job->image);
    aov_destroy(&job->aov);
    adaptive_destroy(&job->adaptive);
    renderer_destroy(&job->renderer);
    context_close(&job->context);
    scene_destroy(&job->scene);
    free(job->library);
    for (int i = 0; i < 5; i++) text_free(&job->recalled[i]);
}

static bool render_scene(RenderJob *job, Error *error) {
    double start = clock_seconds();
    bool ok = prepare(job, error);
    progress_clear(&job->progress);
    if (!ok) return false;
    job->figures.startup_seconds = clock_seconds() - start;
    if (job->options->verbose || job->options->files) render_say_choices(job);
    if (!render_run(job, error) || !render_write(job, error)) return false;
    if (!job->options->quiet) render_say_summary(job);
    fflush(stdout);
    /* The check compiles a program, which may take long: all is saved before it. */
    interrupt_saved();
    if (!job->figures.interrupted &&
        !check_scene(&job->check, &job->context, &job->params, &job->renderer, error))
        return false;
    render_warn(job);
    saver_say(job);
    return true;
}

static double compile_seconds(const Options *options) {
    return options->compile_seconds > 0 ? options->compile_seconds : 60;
}

Status cmd_render(const Options *options, int argc, char **argv, Error *error) {
    RenderJob job = {.options = options, .argc = argc, .argv = argv, .progress = progress_start(options)};
    error->status = STATUS_DONE;
    interrupt_install();
    interrupt_answer();
    bool ok = open_scene(&job, error) && render_check_frames(&job, error);
    if (ok) interrupt_limit_compiling(compile_seconds(options), job.scene.file->path);
    if (ok && render_is_toy(&job))
        ok = render_toy(&job, argc, argv, error);
    else
        ok = ok && render_scene(&job, error);
    progress_clear(&job.progress);
    bool interrupted = job.figures.interrupted, missing = job.output_missing;
    bool broken = options->error.amount > 0 && !job.promise.given;
    release(&job);
    if (!ok) return error->status;
    return missing       ? STATUS_OUTPUT
           : interrupted ? STATUS_INTERRUPTED
           : broken      ? STATUS_UNPROMISED
                         : STATUS_DONE;
}
