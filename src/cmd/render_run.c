#include "cmd/render_run.h"

#include "base/clock.h"
#include "choice/auto.h"
#include "cmd/interrupt.h"
#include "cmd/render_write.h"
#include "cmd/saver.h"
#include "render/chance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The error at which to stop, if there is one. */
static ErrorTarget target_of(const Options *options) {
    ErrorTarget none = {0}, usual = {.amount = AUTO_ERROR_PERCENT};
    if (options->error.amount > 0) return options->error;
    return options->samples || options->seconds > 0 ? none : usual;
}

double render_bias(const RenderJob *job, NoiseMeasure measure) {
    double slope = tone_levels_per_percent(render_tone(job->options));
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
    if (figures->target_samples && figures->samples >= (double)figures->target_samples &&
        !job->adaptive.under_way)
        return true;
    AdaptiveEnd end = adaptive_end(&job->adaptive);
    /* Where the time alone is limited, it ends before its time only if nothing can be added any more. */
    if (figures->target.amount > 0
            ? figures->noise[figures->target.measure] <= figures->target_noise || end != ADAPTIVE_GOES_ON
            : end == ADAPTIVE_FULL)
        return true;
    return figures->target_seconds > 0 && figures->seconds - job->earlier_seconds >= figures->target_seconds;
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

/* Sets the targets, and what is measured on the way. */
static void aim(RenderJob *job, double start) {
    const Options *options = job->options;
    ProgressFigures *figures = &job->figures;
    ErrorTarget target = target_of(options);
    ToneTable tone = tone_table(render_tone(options), exp2(job->scene.values.exposure_ev));
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
    if (!aov_complete(&job->aov, error) || !render_read(job, error)) return false;
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

/* Notes what there is so far. The error is that of the last round that is complete. */
static void note(RenderJob *job, double start) {
    ProgressFigures *figures = &job->figures;
    const Rectangle *area = &job->renderer.area;
    figures->paths = job->adaptive.paths;
    if (job->renderer.plan.sun.method->traces_light) figures->light_paths = job->renderer.film.light_paths;
    figures->samples = (double)figures->paths / ((double)area->width * area->height);
    if (!job->adaptive.under_way) note_errors(job);
    figures->seconds = job->earlier_seconds + clock_seconds() - start;
}

/* Brings the further layers to the picture's samples. They are taken between rounds only, so that their
 * groups are the same however the rounds were cut. */
static bool add_layers(RenderJob *job, Error *error) {
    return job->adaptive.under_way ||
           aov_pass(&job->aov, &job->renderer, (uint64_t)job->figures.samples, interrupt_requested, error);
}

bool render_run(RenderJob *job, Error *error) {
    double start = clock_seconds();
    aim(job, start);
    if (!saver_begin(job, error)) return false;
    if (job->adaptive.paths) interrupt_keep();
    note(job, start);
    if (!add_layers(job, error)) return false;
    while (!enough(job) && !interrupt_requested()) {
        if (!sample(job, error)) return false;
        interrupt_keep();
        note(job, start);
        if (!add_layers(job, error) || !saver_save(job, error)) return false;
        job->figures.seconds = job->earlier_seconds + clock_seconds() - start;
        if (!enough(job)) progress_report(&job->progress, &job->figures);
    }
    if (!saver_end(job, error) || !adaptive_settle(&job->adaptive, &job->renderer, error)) return false;
    note(job, start);
    return finish(job, error);
}
