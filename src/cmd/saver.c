#include "cmd/saver.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/text.h"
#include "choice/method.h"
#include "cmd/interrupt.h"
#include "cmd/outputs.h"
#include "cmd/render_write.h"
#include "error/checkpoint.h"
#include "render/identity.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Seconds between checkpoints, if the user says nothing. */
static const double usual_interval = 60;

/* The time of clock_seconds() at which the next checkpoint is due. */
static double due = INFINITY;

bool saver_wants(void) {
    return interrupt_requested() || interrupt_picture_asked() || clock_seconds() >= due;
}

bool saver_check(const Options *options, Error *error) {
    const char *path = options->checkpoint;
    if (options->checkpoint_seconds > 0 && !path)
        return error_set(error, STATUS_USAGE, "--checkpoint-every: which file? (--checkpoint FILE)");
    if (!path) return true;
    for (int i = 0; i < options->output_count; i++) {
        if (strcmp(options->outputs[i], path) == 0)
            return error_set(error, STATUS_USAGE, "%s is both the checkpoint and a picture (-o)", path);
    }
    if (file_is_special(path))
        return error_set(error, STATUS_OUTPUT, "%s: a checkpoint is a regular file", path);
    return file_check_target(path, error);
}

static Checkpoint checkpoint_of(RenderJob *job, const Text *identity, const Text *driver) {
    return (Checkpoint){.renderer = &job->renderer,
                        .adaptive = &job->adaptive,
                        .aov = &job->aov,
                        .seconds = job->earlier_seconds,
                        .identity = text_string(identity),
                        .driver = text_string(driver)};
}

static bool is_new(const Options *options) {
    bool same = options->checkpoint && strcmp(options->checkpoint, options->resume) == 0;
    return same && access(options->resume, F_OK) != 0;
}

void saver_recall(RenderJob *job) {
    static const char *const names[] = {"sky", "further", "light", "sequence", "sun-disk"};
    RenderParams *params = &job->params;
    const char **targets[] = {&params->sky, &params->further, &params->light, &params->sequence,
                              &params->sun_disk};
    const Options *options = job->options;
    Text file = {0}, lines = {0};
    Error error;
    FileBounds bounds = {.status = STATUS_FAILURE, .most = CHECKPOINT_MOST, .begins_well = checkpoint_is_one};
    /* What is wrong with the file is said when it is loaded. */
    bool known = options->resume && !is_new(options) &&
                 file_read_within(options->resume, &bounds, &file, &error) &&
                 checkpoint_lines(options->resume, &file, &lines, &error);
    for (int i = 0; known && i < 5; i++) {
        bool open = method_is_auto(*targets[i]);
        if (open && identity_value(text_string(&lines), names[i], &job->recalled[i]))
            *targets[i] = text_string(&job->recalled[i]);
    }
    text_free(&file);
    text_free(&lines);
}

static void print_driver(const RenderJob *job, Text *driver) {
    text_print(driver, "%s, OpenGL %s", job->context.renderer, job->context.version);
}

/* --spp can only go on where all pixels have the same number of samples. */
static bool check_loaded(const RenderJob *job, Error *error) {
    const Noise *noise = &job->adaptive.noise;
    uint64_t even = job->renderer.film.samples, most = 0;
    for (int i = 0; i < noise_tile_count(noise); i++)
        if (noise->tiles[i].samples > most) most = noise->tiles[i].samples;
    return !job->options->samples || most <= even ||
           error_set(error, STATUS_USAGE,
                     "%s: its pixels have %" PRIu64 " to %" PRIu64
                     " samples, and --spp takes the same number of each: go on with --error or --time",
                     job->options->resume, even, most);
}

static bool load(RenderJob *job, Error *error) {
    const char *path = job->options->resume;
    Text identity = {0}, driver = {0};
    char *other = NULL;
    bool ok = render_identity(job, &identity, error);
    print_driver(job, &driver);
    Checkpoint checkpoint = checkpoint_of(job, &identity, &driver);
    ok = ok && checkpoint_read(path, &checkpoint, &other, error);
    if (ok) job->earlier_seconds = checkpoint.seconds;
    if (ok && other)
        fprintf(stderr,
                "magichour: warning: %s was begun by another driver (%s): the picture goes on with this one, "
                "and is not the same to the bit as by either alone\n",
                path, other);
    free(other);
    text_free(&identity);
    text_free(&driver);
    return ok && check_loaded(job, error);
}

bool saver_begin(RenderJob *job, Error *error) {
    const Options *options = job->options;
    double seconds = options->checkpoint_seconds;
    job->adaptive.pause = saver_wants;
    if (options->checkpoint) due = clock_seconds() + (seconds > 0 ? seconds : usual_interval);
    if (!options->resume || is_new(options)) return true;
    return load(job, error);
}

static void print_about(const RenderJob *job, Text *about) {
    Text command = {0};
    text_print_command(&command, job->argc, job->argv);
    text_print(about, "scene %s\ncommand %s\nsamples %.6g\nseconds %.1f\n", job->scene.file->path,
               text_string(&command), job->figures.samples, job->figures.seconds);
    if (job->figures.error[job->adaptive.measure] < INFINITY)
        text_print(about, "error %.3g %s\n", job->figures.error[job->adaptive.measure],
                   job->adaptive.measure == NOISE_LEVELS ? "levels" : "%");
    text_free(&command);
}

/* A first group of samples that was stopped lacks rows: there is nothing to go on with. */
static bool write_checkpoint(RenderJob *job, Error *error) {
    if (!job->options->checkpoint || job->renderer.partial || !job->renderer.film.samples) return true;
    Text identity = {0}, driver = {0}, about = {0};
    bool ok = render_identity(job, &identity, error);
    print_driver(job, &driver);
    print_about(job, &about);
    Checkpoint checkpoint = checkpoint_of(job, &identity, &driver);
    checkpoint.about = text_string(&about);
    checkpoint.seconds = job->figures.seconds;
    ok = ok && checkpoint_write(job->options->checkpoint, &checkpoint, error);
    text_free(&identity);
    text_free(&driver);
    text_free(&about);
    job->checkpoint_written = ok;
    return ok;
}

/* Writes the picture that SIGUSR1 asked for. */
static bool write_picture(RenderJob *job, Error *error) {
    bool ok = render_read(job, error) && render_write(job, error);
    image_free(&job->image);
    job->image = (Image){0};
    if (!ok) return false;
    progress_clear(&job->progress);
    for (int i = 0; !job->options->quiet && i < job->options->output_count; i++)
        fprintf(stderr, "magichour: the picture so far: %s, %.4g samples\n",
                outputs_name(job->options->outputs[i]), job->figures.samples);
    return true;
}

/* What cannot be written does not end the render: its picture would be lost with it. */
static bool forgive(RenderJob *job, bool ok, Error *error) {
    if (ok || error->status != STATUS_OUTPUT) return ok;
    progress_clear(&job->progress);
    fprintf(stderr, "magichour: warning: %s: the render goes on without it\n", error->text);
    *error = (Error){.status = STATUS_DONE};
    job->output_missing = true;
    return true;
}

bool saver_save(RenderJob *job, Error *error) {
    if (interrupt_picture_asked()) {
        interrupt_picture_done();
        if (!forgive(job, write_picture(job, error), error)) return false;
    }
    if (interrupt_requested() || clock_seconds() < due) return true;
    double seconds = job->options->checkpoint_seconds;
    bool ok = forgive(job, write_checkpoint(job, error), error);
    due = clock_seconds() + (seconds > 0 ? seconds : usual_interval);
    return ok;
}

bool saver_end(RenderJob *job, Error *error) {
    job->output_missing = false;
    return forgive(job, write_checkpoint(job, error), error);
}

void saver_say(const RenderJob *job) {
    const Options *options = job->options;
    if (!job->figures.interrupted || !options->checkpoint || options->quiet) return;
    if (!job->checkpoint_written) {
        fprintf(stderr, "magichour: no checkpoint: %s\n",
                job->output_missing ? "it could not be written" : "not one group of samples was complete");
        return;
    }
    Text command = {0};
    text_print_command(&command, job->argc, job->argv);
    if (!options->resume || strcmp(options->resume, options->checkpoint) != 0) {
        text_print(&command, " --resume ");
        text_print_quoted(&command, options->checkpoint);
    }
    fprintf(stderr, "magichour: the checkpoint is %s; to go on: %s\n", options->checkpoint,
            text_string(&command));
    text_free(&command);
}
