#include "chart/worth.h"

#include "base/clock.h"
#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_SEED = 1, ROUNDS = 5 };
static const double timing_seconds = 0.5;
/* The share of the pixels that is left out if the sun's image is in the picture. */
static const double trimmed_share = 0.001;

static bool render(Renderer *renderer, const Context *context, const RenderParams *params, unsigned seed,
                   unsigned samples, bool (*stop)(void), Image *image, Error *error) {
    RenderParams seeded = *params;
    Film *film = &renderer->film;
    FilmCount count;
    seeded.seed = seed;
    if (!renderer_restart(renderer, context, &seeded, error)) return false;
    while (film->samples < samples && !(stop && stop())) {
        if (!renderer_pass(renderer, samples - film->samples, stop, error)) return false;
    }
    return film_read(film, image, &count, error);
}

static bool render_both(Renderer *renderer, const Context *context, const RenderParams *params,
                        unsigned samples, bool (*stop)(void), Image pictures[2], Error *error) {
    return render(renderer, context, params, FIRST_SEED, samples, stop, &pictures[0], error) &&
           render(renderer, context, params, FIRST_SEED + 1, samples, stop, &pictures[1], error);
}

bool worth_begin(WorthBase *base, const Context *context, const RenderParams *params, unsigned samples,
                 bool (*stop)(void), Error *error) {
    *base = (WorthBase){.params = params, .context = context, .samples = samples};
    if (!renderer_create(&base->renderer, context, params, error)) return false;
    if (stopwatch_start(&base->stopwatch, &base->renderer, error) &&
        render_both(&base->renderer, context, params, samples, stop, base->pictures, error))
        return true;
    worth_end(base);
    return false;
}

void worth_end(WorthBase *base) {
    renderer_destroy(&base->renderer);
    image_free(&base->pictures[0]);
    image_free(&base->pictures[1]);
    *base = (WorthBase){0};
}

/* A pixel's value, and the number that pixels are sorted by. */
typedef struct Sorted {
    double size, value;
} Sorted;

static int by_size(const void *left, const void *right) {
    double a = ((const Sorted *)left)->size, b = ((const Sorted *)right)->size;
    return (a > b) - (a < b);
}

/* Sorts the pixels, and returns how many are left if the largest, the trimmed share, are left out. */
static size_t set_aside(Sorted *pixels, size_t count) {
    qsort(pixels, count, sizeof *pixels, by_size);
    size_t aside = (size_t)ceil(trimmed_share * (double)count);
    return count > aside ? count - aside : 1;
}

/* Returns the mean over pixels and channels. If `trim` is set, the brightest pixels are left out, such as the
 * sun. */
static double mean_of(const Image *image, bool trim) {
    size_t count = (size_t)image->width * (size_t)image->height;
    Sorted *pixels = memory_get(count, sizeof *pixels);
    double sum = 0;
    for (size_t i = 0; i < 4 * count; i++) {
        if (i % 4 < 3) pixels[i / 4].size += (double)image->rgba[i] / 3;
    }
    size_t left = trim ? set_aside(pixels, count) : count;
    for (size_t i = 0; i < left; i++) sum += pixels[i].size;
    free(pixels);
    return sum / (double)left;
}

/* The differences for two seeds have the same mean and independent noise. The mean of their product is
 * therefore the square of that mean, without noise. `trim` leaves out the pixels that differ most: the sun's
 * image, and rare bright paths. */
static void measure_change(const Image base[2], const Image other[2], bool trim, Worth *worth) {
    size_t count = (size_t)base->width * (size_t)base->height;
    Sorted *products = memory_get(count, sizeof *products);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < 4 * count; i++) {
        if (i % 4 == 3) continue;
        double a = (double)other[0].rgba[i] - (double)base[0].rgba[i];
        double b = (double)other[1].rgba[i] - (double)base[1].rgba[i];
        products[i / 4].size += a * a + b * b;
        products[i / 4].value += a * b / 3;
    }
    size_t left = trim ? set_aside(products, count) : count;
    for (size_t i = 0; i < left; i++) {
        sum += products[i].value;
        squares += products[i].value * products[i].value;
    }
    double mean = sum / (double)left, picture = mean_of(&base[0], trim);
    double deviation = sqrt(fmax(squares / (double)left - mean * mean, 0) / (double)left);
    worth->change_percent = picture > 0 ? 100 * sqrt(fmax(mean, 0)) / picture : 0;
    worth->change_known = picture > 0 ? 100 * sqrt(2 * deviation) / picture : 0;
    free(products);
}

/* Returns the mean square of the noise in a picture. It is at least that of a millionth of the picture's
 * light, which is rounding. */
static double noise_of(const Image pictures[2]) {
    size_t pixels = (size_t)pictures->width * (size_t)pictures->height;
    double squares = 0, least = 1e-6 * mean_of(&pictures[0], false);
    for (size_t i = 0; i < 4 * pixels; i++) {
        double difference = i % 4 < 3 ? (double)pictures[0].rgba[i] - (double)pictures[1].rgba[i] : 0;
        squares += difference * difference / 2;
    }
    return fmax(squares / (3 * (double)pixels), least * least);
}

static bool time_both(WorthBase *base, Renderer *renderer, Stopwatch *other, bool (*stop)(void),
                      Error *error) {
    if (!stopwatch_start(&base->stopwatch, &base->renderer, error)) return false;
    for (int i = 0; i < ROUNDS || base->stopwatch.spent + other->spent < timing_seconds; i++) {
        if (stop && stop()) return true;
        if (!stopwatch_group(&base->stopwatch, &base->renderer, error) ||
            !stopwatch_group(other, renderer, error))
            return false;
        if (i >= 1 && other->spent > 3 * timing_seconds) break;
    }
    return true;
}

/* Returns the seconds of a sample, by the renderer's own group. */
static double sample_seconds(const Stopwatch *stopwatch, const Renderer *renderer) {
    return stopwatch_seconds(stopwatch, renderer, renderer->plan.group_samples) /
           renderer->plan.group_samples;
}

static bool compare(WorthBase *base, const Term *term, const Variation *variation, Renderer *renderer,
                    bool (*stop)(void), Worth *worth, Error *error) {
    Stopwatch other;
    Image pictures[2] = {{0}};
    bool ok =
        stopwatch_start(&other, renderer, error) &&
        render_both(renderer, base->context, &variation->params, base->samples, stop, pictures, error) &&
        time_both(base, renderer, &other, stop, error);
    if (ok && !(stop && stop())) {
        bool on = worth->state == TERM_ON;
        bool trim = base->renderer.image.where.count || renderer->image.where.count;
        double ratio = sample_seconds(&base->stopwatch, &base->renderer) / sample_seconds(&other, renderer);
        double noise = noise_of(base->pictures) / noise_of(pictures);
        worth->cost_percent = 100 * ((on ? ratio : 1 / ratio) - 1);
        worth->gain = on ? 1 / (noise * ratio) : noise * ratio;
        if (!term->same_picture) measure_change(base->pictures, pictures, trim, worth);
    }
    image_free(&pictures[0]);
    image_free(&pictures[1]);
    return ok;
}

/* Measures the seconds in which all tables of a renderer are filled for other values than before. */
static bool time_tables(Renderer *renderer, const Context *context, const RenderParams *params,
                        double *seconds, Error *error) {
    renderer->gl->Finish();
    double start = clock_seconds();
    bool ok = renderer_restart(renderer, context, params, error);
    renderer->gl->Finish();
    *seconds = clock_seconds() - start;
    return ok;
}

/* The base and the variation are timed one after the other, so that a busy minute slows both. Their planets
 * are made larger by some millionths of a percent. All tables are filled anew by that, while the programs and
 * the picture stay. */
static bool compare_tables(WorthBase *base, Variation *variation, Renderer *renderer, Worth *worth,
                           Error *error) {
    double ours, other, larger = 1 + 1e-8 * ++base->steps;
    Variation *same = variation_create(base->params);
    same->scene.values.atmosphere.planet_radius_m *= larger;
    variation->scene.values.atmosphere.planet_radius_m *= larger;
    bool ok = time_tables(&base->renderer, base->context, &same->params, &ours, error) &&
              time_tables(renderer, base->context, &variation->params, &other, error);
    if (ok) worth->once_seconds = worth->state == TERM_ON ? ours - other : other - ours;
    free(same);
    return ok;
}

/* Whether the variation has the base's air and the methods `before` of looking at it, so that all tables that
 * take long are the same. */
static bool has_same_tables(const WorthBase *base, const RenderParams *before, const Variation *variation) {
    const Atmosphere *a = &base->params->scene->values.atmosphere, *b = &variation->scene.values.atmosphere;
    return memcmp(a, b, sizeof *a) == 0 && before->sky == variation->params.sky &&
           before->further == variation->params.further;
}

bool worth_of(WorthBase *base, const Term *term, bool (*stop)(void), Worth *worth, Error *error) {
    *worth = (Worth){.state = term->state(term, base->params, &base->renderer)};
    if (worth->state == TERM_NONE) return true;
    Variation *variation = variation_create(base->params);
    Renderer renderer;
    /* The other methods stay as they are, because the choice of auto may depend on the term that is turned.
     * An air of one order has no quality of further orders that could stay. */
    if (base->renderer.plan.sky.method->integrates) variation->params.sky = base->renderer.plan.sky.text;
    if (base->params->scene->values.atmosphere.orders > 1)
        variation->params.further = base->renderer.plan.further.text;
    variation->params.light = base->renderer.plan.light.text;
    variation->params.sequence = base->renderer.plan.sequence.text;
    RenderParams before = variation->params;
    term->turn(term, variation, worth->state == TERM_OFF);
    bool ok = renderer_create(&renderer, base->context, &variation->params, error);
    if (ok) {
        ok = (has_same_tables(base, &before, variation) ||
              compare_tables(base, variation, &renderer, worth, error)) &&
             compare(base, term, variation, &renderer, stop, worth, error);
        renderer_destroy(&renderer);
    }
    free(variation);
    return ok;
}
