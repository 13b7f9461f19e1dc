#include "cmd/outputs.h"
#include "cmd/render_job.h"

#include "render/chance.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

static void say_why(const char *what, const MethodChoice *choice) {
    if (choice->why[0]) fprintf(stderr, "auto took %s %s: %s\n", what, choice->text, choice->why);
}

void render_say_backend(const RenderJob *job) {
    fprintf(stderr, "backend %s (%s): %s, OpenGL %s\n", job->context.backend->name, job->context.detail,
            job->context.renderer, job->context.version);
}

void render_say_choices(const RenderJob *job) {
    const Renderer *renderer = &job->renderer;
    render_say_backend(job);
    fprintf(stderr, "sky %s, sun disk %s, light %s, sequence %s, at most %d hits, groups of %u samples\n",
            renderer->plan.sky.text, renderer->plan.sun.text, renderer->plan.light.text,
            renderer->plan.sequence.text, renderer->plan.max_hits, renderer->plan.group_samples);
    say_why("sky", &renderer->plan.sky);
    if (job->scene.values.atmosphere.orders > 1)
        fprintf(stderr, "further orders of scattering by %s\n", renderer->plan.further.text);
    if (renderer->plan.sky.method->integrates) say_why("further orders", &renderer->plan.further);
    say_why("light", &renderer->plan.light);
    const Resource *table = resources_find(&renderer->tables, &sky_table);
    if (table) {
        fprintf(stderr, "the sky's table: twice %dx%d directions, above the horizon and below\n",
                table->width, table->height / 2);
    }
    if (job->options->files) fprintf(stderr, "compiled: %s\n", text_string(&renderer->source_files));
}

/* Prints the picture's error and its parts. */
static void say_error(const RenderJob *job) {
    const ProgressFigures *figures = &job->figures;
    const Noise *noise = &job->adaptive.noise;
    NoiseMeasure measure = figures->target.measure;
    const char *unit = measure == NOISE_LEVELS ? "levels" : "%";
    double bias = render_bias(job, measure), error = figures->error[measure];
    if (error < INFINITY) {
        printf("; estimated error %.3g %s%s: noise %.3g %s", error, unit,
               noise->counted < (long)noise->area.width * noise->area.height ? " without the sun's own image"
                                                                             : "",
               figures->noise[measure], unit);
    }
    if (isnan(bias))
        printf("; the sky's bias is not known here");
    else if (bias > 0)
        printf("%s sky %.2g %s at most", error < INFINITY ? "," : ";", bias, unit);
    if (job->options->depth) printf("; without what --depth cuts");
    if (figures->promise && !job->promise.given) printf("; not promised");
}

void render_say_summary(const RenderJob *job) {
    const ProgressFigures *figures = &job->figures;
    const Adaptive *adaptive = &job->adaptive;
    for (int i = 0; i < job->options->output_count; i++)
        printf("%s%s", i ? ", " : "", outputs_name(job->options->outputs[i]));
    printf(": %.4g samples", figures->samples);
    if (adaptive->most > adaptive->least)
        printf(" (%" PRIu64 " to %" PRIu64 ")", adaptive->least, adaptive->most);
    printf(", %.4g Mpaths", 1e-6 * (double)figures->paths);
    if (figures->light_paths > 0) printf(" and %.4g Mpaths from the sun", 1e-6 * figures->light_paths);
    printf(" in %.2f s, %.2f Mpaths/s (and %.2f s to start)", figures->seconds,
           1e-6 * (double)figures->paths / fmax(figures->seconds, 1e-9), figures->startup_seconds);
    say_error(job);
    printf("\n");
}

static void warn_search(const RenderJob *job) {
    const FilmSearch *search = &job->search;
    const char *path = job->scene.file->path;
    if ((job->options->verbose || job->options->files) && search->rays > 0) {
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

static void warn_chance(const RenderJob *job) {
    const ChanceShares *chance = &job->chance;
    const Plan *plan = &job->renderer.plan;
    char throwers[200];
    if (job->renderer.sun_by_chance)
        fprintf(stderr, "magichour: warning: --sun-disk=chance: all sunlight is found by chance\n");
    if (job->renderer.sun_by_chance || !chance_matters(chance)) return;
    chance_throwers(chance->materials, &job->scene.file->facts, throwers, sizeof throwers);
    fprintf(stderr,
            "magichour: warning: %s: sunlight that is thrown by %s is found by chance: about %.2g %% of the "
            "picture's light, in %.2g %% of its pixels (%.2g %% of the paths)%s\n",
            job->scene.file->path, throwers, 100 * chance->light, 100 * chance->pixels, 100 * chance->paths,
            plan->sun.method->traces_light ? ": it is seen in mirrors or through glass"
            : plan->mist || plan->air      ? ""
                                           : "; --sun-disk=traced finds most of it");
}

static void warn_promise(const RenderJob *job) {
    char target[48];
    if (!job->figures.promise || job->promise.given || job->figures.interrupted) return;
    ErrorTarget wanted = job->figures.target;
    snprintf(target, sizeof target, "%.6g %s", wanted.amount,
             wanted.measure == NOISE_LEVELS ? "levels" : "%");
    fprintf(stderr, "magichour: warning: an error of %s is not promised: %s\n", target, job->promise.reason);
}

static void warn_check(const RenderJob *job) {
    Text lines = {0};
    check_print(&job->check, job->scene.file->path, &lines);
    fputs(text_string(&lines), stderr);
    text_free(&lines);
}

static void warn_rejected(const RenderJob *job) {
    const FilmCount *count = &job->count;
    if (count->rejected) {
        fprintf(stderr,
                "magichour: warning: %" PRIu64 " of %" PRIu64
                " samples were not finite, or too large to be summed%s, and are left out\n",
                count->rejected, count->accepted + count->rejected,
                job->search.rays > 0 ? ", or took more loops than the driver allows" : "");
    }
    if (count->light_rejected) {
        fprintf(stderr,
                "magichour: warning: %" PRIu64 " of %" PRIu64
                " points of light were not finite, or too large to be summed, and are left out\n",
                count->light_rejected, count->light);
    }
}

void render_warn(const RenderJob *job) {
    program_say_warnings(&job->renderer.program, stderr);
    if (job->options->further && !(job->scene.values.atmosphere.orders > 1))
        fprintf(stderr,
                "magichour: warning: --further has no effect: the air has the first order alone (--orders "
                "says how many it has)\n");
    if (job->options->verbose || job->options->files)
        fprintf(stderr, "%ld draws, the longest %.3f s\n", job->renderer.pace.draws,
                job->renderer.pace.longest_s);
    warn_promise(job);
    if (!job->figures.promise && adaptive_end(&job->adaptive) == ADAPTIVE_FULL)
        fprintf(stderr,
                "magichour: warning: it ended before its time: the pixels have as many samples as are "
                "counted, 2^23\n");
    warn_check(job);
    if (job->variance_unknown) {
        fprintf(
            stderr,
            "magichour: warning: --aov variance is not known from %u samples or fewer, or where it is too "
            "large for a float: there it is NaN\n",
            job->renderer.plan.group_samples);
    }
    warn_rejected(job);
    warn_chance(job);
    warn_search(job);
}
