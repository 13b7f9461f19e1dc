#include "cmd/render_toy.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/version.h"
#include "cmd/interrupt.h"
#include "cmd/outputs.h"
#include "cmd/toy_options.h"
#include "image/format.h"
#include "render/toy.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool render_is_toy(const RenderJob *job) {
    return job->scene.file->facts.is_toy;
}

bool render_check_frames(const RenderJob *job, Error *error) {
    if (!job->options->frames || render_is_toy(job)) return true;
    return error_set(error, STATUS_USAGE,
                     "--frames: %s is a scene, which has no frames: --spp says how many samples it gets",
                     job->scene.file->path);
}

/* Places in a pixel that fill it evenly, however many they are; the first is the middle. These are Roberts's
 * numbers. */
static void place_sample(uint64_t number, double shift[3]) {
    shift[0] = fmod(0.5 + 0.7548776662466927 * (double)number, 1) - 0.5;
    shift[1] = fmod(0.5 + 0.5698402909980532 * (double)number, 1) - 0.5;
}

/* Shadertoy's own rate, for the time of frames behind the first. */
static const double frame_s = 1.0 / 60;

static int frames_of(const RenderJob *job) {
    return job->options->frames ? job->options->frames : 1;
}

static double time_of(const RenderJob *job, int frame) {
    return job->scene.values.time_s + frame * frame_s;
}

/* Draws one sample of each pixel, with all frames that lead to it, and adds it to `sums`. Returns false in
 * `whole` if it was interrupted. */
static bool add_sample(const RenderJob *job, Toy *toy, uint64_t number, double *sums, bool *whole,
                       Error *error) {
    size_t values = 4 * (size_t)toy->target.width * (size_t)toy->target.height;
    ToyMoment moment = {.time_s = job->scene.values.time_s};
    memcpy(moment.mouse, job->scene.values.mouse, sizeof moment.mouse);
    place_sample(number, moment.shift);
    toy_restart(toy);
    while (toy->frame < frames_of(job) && !interrupt_requested()) {
        moment.time_s = time_of(job, toy->frame);
        moment.delta_s = toy->frame ? frame_s : 0;
        if (!toy_draw(toy, &job->scene, &moment, 0.3, interrupt_requested, error)) return false;
    }
    *whole = toy->frame == frames_of(job);
    if (!*whole) return true;
    float *texels = memory_get(values, sizeof *texels);
    bool ok = target_read(&toy->target, 0, texels, error);
    for (size_t i = 0; i < values; i++) sums[i] += (double)texels[i];
    free(texels);
    return ok;
}

static bool draw(RenderJob *job, Toy *toy, double *sums, Error *error) {
    ProgressFigures *figures = &job->figures;
    double start = clock_seconds(), pixels = (double)toy->target.width * toy->target.height;
    uint64_t count = job->options->samples ? job->options->samples : 1, done = 0;
    bool whole = true;
    figures->target_samples = count;
    for (int i = 0; i < NOISE_MEASURES; i++) figures->noise[i] = figures->error[i] = INFINITY;
    while (done < count && whole) {
        if (!add_sample(job, toy, done, sums, &whole, error)) return false;
        done += whole;
        if (done) interrupt_keep();
        figures->samples = (double)done;
        figures->paths = (uint64_t)(pixels * figures->samples);
        figures->seconds = clock_seconds() - start;
        figures->interrupted = !whole || (done < count && interrupt_requested());
        figures->done = done == count || figures->interrupted;
        progress_report(&job->progress, figures);
    }
    return true;
}

/* Row 0 of the sums is the bottom. */
static void make_image(RenderJob *job, const Toy *toy, const double *sums) {
    Image image = image_create(toy->target.width, toy->target.height);
    size_t row = 4 * (size_t)image.width;
    for (size_t i = 0; i < row * (size_t)image.height; i++) {
        size_t y = (size_t)image.height - 1 - i / row;
        image.rgba[i] = i % 4 < 3 ? (float)(sums[y * row + i % row] / job->figures.samples) : 1.0f;
    }
    job->image = image;
}

static bool write_outputs(const RenderJob *job, int argc, char **argv, Error *error) {
    AttributeList attributes = {0};
    Text command = {0};
    text_print_command(&command, argc, argv);
    attribute_add(&attributes, "magichour.version", "%s", MAGICHOUR_VERSION);
    attribute_add(&attributes, "magichour.command", "%s", text_string(&command));
    attribute_add(&attributes, "magichour.samples", "%.6g", job->figures.samples);
    ImageWriteParams params = {.tone = TONE_SCREEN, .attributes = &attributes};
    bool ok = outputs_write(job->options, &job->image, &params, error);
    attribute_list_free(&attributes);
    text_free(&command);
    return ok;
}

static void say_result(const RenderJob *job) {
    for (int i = 0; i < job->options->output_count; i++)
        printf("%s%s", i ? ", " : "", outputs_name(job->options->outputs[i]));
    printf(": %.0f sample%s of each pixel", job->figures.samples, job->figures.samples == 1 ? "" : "s");
    if (job->options->frames) printf(" of frame %d", job->options->frames - 1);
    printf(" at %g s, in %.2f s (and %.2f s to start)\n", time_of(job, frames_of(job) - 1),
           job->figures.seconds, job->figures.startup_seconds);
}

/* Says what may be wrong with the picture. */
static bool warn(const RenderJob *job, const Toy *toy, Error *error) {
    double cut, broken = 0, pixels = (double)job->image.width * job->image.height;
    if (!toy_cut_share(toy, &cut, error)) return false;
    for (size_t i = 0; i < (size_t)pixels; i++) {
        const float *rgba = job->image.rgba + 4 * i;
        broken += !isfinite(rgba[0]) || !isfinite(rgba[1]) || !isfinite(rgba[2]);
    }
    if (cut > 0) {
        fprintf(stderr, "magichour: warning: %s: %s\n", job->scene.file->path, TOY_CUT_WORDS);
        fprintf(stderr, "magichour: warning: this concerns %.2g %% of the pixels\n", 100 * cut);
    }
    if (broken > 0) {
        fprintf(stderr,
                "magichour: warning: %s: %.2g %% of the pixels have a colour that is no finite number\n",
                job->scene.file->path, 100 * broken / pixels);
    }
    return true;
}

static bool run(RenderJob *job, Toy *toy, int argc, char **argv, Error *error) {
    const SceneFile *file = job->scene.file;
    double start = clock_seconds();
    int width = job->options->width ? job->options->width : file->width,
        height = job->options->height ? job->options->height : file->height;
    if (!toy_compile(toy, &job->context, file, error) ||
        !toy_resize(toy, &job->context, width, height, error))
        return false;
    toy_say_notes(toy, stderr);
    if (job->options->verbose) render_say_backend(job);
    job->figures.startup_seconds = clock_seconds() - start;
    double *sums = memory_get(4 * (size_t)width * (size_t)height, sizeof *sums);
    bool ok = draw(job, toy, sums, error);
    if (ok) make_image(job, toy, sums);
    free(sums);
    if (!ok || !write_outputs(job, argc, argv, error)) return false;
    if (!job->options->quiet) say_result(job);
    return warn(job, toy, error);
}

bool render_toy(RenderJob *job, int argc, char **argv, Error *error) {
    Toy toy = {0};
    if (!toy_options_check(job->options, job->scene.file, error) ||
        !context_open(&job->context, job->options->backend, error))
        return false;
    bool ok = run(job, &toy, argc, argv, error);
    toy_destroy(&toy);
    return ok;
}
