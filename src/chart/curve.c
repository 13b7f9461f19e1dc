#include "chart/curve.h"

#include "base/clock.h"
#include "error/adaptive.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The numbers of a row. LAST is 1 at the end of a curve. */
enum { SAMPLES, SECONDS, ERROR, LAST };

enum { MOST_GOALS = 16 };
static const double first_goal = 16;

static void name(const Renderer *renderer, bool adaptive, LedgerRow *row) {
    *row = (LedgerRow){0};
    snprintf(row->words[3], sizeof row->words[3], "%s", adaptive ? "adaptive" : "even");
    snprintf(row->words[0], sizeof row->words[0], "%s", renderer->plan.sky.text);
    snprintf(row->words[1], sizeof row->words[1], "%s", renderer->plan.light.text);
    snprintf(row->words[2], sizeof row->words[2], "%s", renderer->plan.sequence.text);
    snprintf(row->words[4], sizeof row->words[4], "%s", renderer->plan.sun.text);
}

/* Says whether another point, with twice the samples, would be past the limits. */
static bool is_last(const LedgerRow *row, const CurveLimits *limits) {
    return 2 * row->numbers[SECONDS] > limits->seconds || row->numbers[ERROR] < limits->least_error;
}

static bool is_whole(const Ledger *ledger, const LedgerRow *row) {
    for (int i = 0; i < ledger->count; i++) {
        if (ledger_same(ledger, &ledger->rows[i], row) && ledger->rows[i].numbers[LAST] > 0) return true;
    }
    return false;
}

bool curve_open(Curve *curve, const Combination *combination, const Context *context,
                const RenderParams *params, NoiseMeasure measure, Ledger *ledger, Error *error) {
    RenderParams mine = *params;
    *curve = (Curve){0};
    mine.sky = combination->sky;
    mine.light = combination->light;
    mine.sequence = combination->sequence;
    if (combination->disk) mine.sun_disk = combination->disk;
    mine.samples = 0;
    if (!renderer_create(&curve->renderer, context, &mine, error)) return false;
    curve->open = true;
    curve->adaptive = combination->adaptive;
    curve->measure = measure;
    curve->exposure_ev = params->scene->values.exposure_ev;
    name(&curve->renderer, combination->adaptive, &curve->row);
    if (is_whole(ledger, &curve->row)) {
        curve_close(curve);
        return true;
    }
    if (ledger_drop(ledger, &curve->row, error) &&
        stopwatch_start(&curve->stopwatch, &curve->renderer, error))
        return true;
    curve_close(curve);
    return false;
}

void curve_close(Curve *curve) {
    if (curve->open) renderer_destroy(&curve->renderer);
    curve->open = false;
}

static bool render(Renderer *renderer, uint64_t samples, const Monitor *monitor, Error *error) {
    Film *film = &renderer->film;
    film_reset(film);
    while (film->samples < samples && !monitor_stopped(monitor)) {
        if (!renderer_pass(renderer, samples - film->samples, monitor->stop, error)) return false;
    }
    return true;
}

static bool judge(const Curve *curve, const Reference *reference, LedgerRow *row, Error *error) {
    Image image = {0};
    FilmCount count;
    bool ok = film_read(&curve->renderer.film, &image, &count, error) &&
              reference_error(reference, &image, curve->measure, &row->numbers[ERROR], error);
    image_free(&image);
    return ok;
}

static bool measure_even(Curve *curve, const Reference *reference, const CurveLimits *limits,
                         const Monitor *monitor, Ledger *ledger, const char *words, Error *error) {
    Renderer *renderer = &curve->renderer;
    LedgerRow *row = &curve->row;
    for (uint64_t samples = 1;; samples *= 2) {
        row->numbers[SAMPLES] = (double)samples;
        row->numbers[SECONDS] = stopwatch_seconds(&curve->stopwatch, renderer, samples);
        monitor_report(monitor, fmin(row->numbers[SECONDS] / limits->seconds, 1), words);
        if (!render(renderer, samples, monitor, error)) return false;
        if (monitor_stopped(monitor)) return true;
        if (!judge(curve, reference, row, error)) return false;
        row->numbers[LAST] = is_last(row, limits);
        if (!ledger_add(ledger, row, error)) return false;
        if (row->numbers[LAST] > 0) return true;
    }
}

static bool time_round(Goals *goals, Adaptive *adaptive, Renderer *renderer, double goal,
                       const Monitor *monitor, Error *error) {
    int round = adaptive->rounds;
    double start = clock_seconds();
    if (!adaptive_round(adaptive, renderer, goal, monitor->stop, error)) return false;
    double seconds = clock_seconds() - start;
    goals->best[round] = round < goals->round_count ? fmin(goals->best[round], seconds) : seconds;
    if (goals->round_count <= round) goals->round_count = round + 1;
    return true;
}

static double seconds_of(const Goals *goals, int rounds) {
    double seconds = 0;
    for (int i = 0; i < rounds; i++) seconds += goals->best[i];
    return seconds;
}

static bool judge_goal(Curve *curve, const Adaptive *adaptive, const Reference *reference, Error *error) {
    Goals *goals = &curve->goals;
    const Film *film = &curve->renderer.film;
    LedgerRow *row = &goals->rows[goals->count];
    *row = curve->row;
    row->numbers[SAMPLES] = (double)adaptive->paths / ((double)film->width * film->height);
    row->numbers[SECONDS] = seconds_of(goals, adaptive->rounds);
    goals->rounds[goals->count++] = adaptive->rounds;
    return judge(curve, reference, row, error);
}

/* Renders rounds until adaptive sampling estimates its error to be at most `goal`, or until it has made
 * `most` rounds. */
static bool sample_to(Goals *goals, Adaptive *adaptive, Renderer *renderer, double goal, int most,
                      const Monitor *monitor, Error *error) {
    while (!(adaptive_error(adaptive, adaptive->measure) <= goal) && adaptive->rounds < most &&
           !monitor_stopped(monitor)) {
        if (!time_round(goals, adaptive, renderer, goal, monitor, error)) return false;
    }
    return true;
}

/* The first run finds the goals. The other runs have `reference` NULL, and make as many rounds. */
static bool run_adaptive(Curve *curve, const Reference *reference, const CurveLimits *limits,
                         const Monitor *monitor, Error *error) {
    Renderer *renderer = &curve->renderer;
    Goals *goals = &curve->goals;
    film_reset(&renderer->film);
    renderer->gl->Finish();
    ToneTable tone = tone_table(TONE_AUTHOR, exp2(curve->exposure_ev));
    Adaptive adaptive =
        adaptive_create(renderer, curve->measure, curve->measure == NOISE_LEVELS ? &tone : NULL);
    int most = reference ? CURVE_MOST_ROUNDS : goals->round_count;
    bool ok = true, done = false;
    double goal = first_goal;
    for (int i = 0; i < MOST_GOALS && ok && !done && !monitor_stopped(monitor); i++, goal /= 2) {
        int before = adaptive.rounds;
        ok = sample_to(goals, &adaptive, renderer, goal, most, monitor, error);
        if (!ok || !reference || monitor_stopped(monitor) || adaptive.rounds == before) continue;
        ok = judge_goal(curve, &adaptive, reference, error);
        done = is_last(&goals->rows[goals->count - 1], limits);
    }
    adaptive_destroy(&adaptive);
    return ok;
}

bool curve_time(Curve *curve, const Reference *reference, const CurveLimits *limits, const Monitor *monitor,
                Error *error) {
    double start = clock_seconds();
    bool first = !curve->goals.round_count;
    bool ok = curve->adaptive ? run_adaptive(curve, first ? reference : NULL, limits, monitor, error)
                              : stopwatch_sizes(&curve->stopwatch, &curve->renderer, error);
    curve->spent += clock_seconds() - start;
    return ok;
}

/* Adds the points of an adaptive curve to the ledger. They are known since its first run. */
static bool keep_goals(const Curve *curve, Ledger *ledger, Error *error) {
    const Goals *goals = &curve->goals;
    for (int i = 0; i < goals->count; i++) {
        LedgerRow row = goals->rows[i];
        row.numbers[SECONDS] = seconds_of(goals, goals->rounds[i]);
        row.numbers[LAST] = i == goals->count - 1;
        if (!ledger_add(ledger, &row, error)) return false;
    }
    return true;
}

bool curve_measure(Curve *curve, const Reference *reference, const CurveLimits *limits,
                   const Monitor *monitor, Ledger *ledger, Error *error) {
    const LedgerRow *row = &curve->row;
    char words[224];
    snprintf(words, sizeof words, "%s %s %s %s", row->words[0], row->words[1], row->words[2], row->words[3]);
    return curve->adaptive ? keep_goals(curve, ledger, error)
                           : measure_even(curve, reference, limits, monitor, ledger, words, error);
}

int curve_points(const Ledger *ledger, const LedgerRow *row, ParetoPoint points[CURVE_MOST_POINTS]) {
    int count = 0;
    for (int i = 0; i < ledger->count && count < CURVE_MOST_POINTS; i++) {
        const LedgerRow *at = &ledger->rows[i];
        if (!ledger_same(ledger, at, row) || !(at->numbers[ERROR] > 0)) continue;
        points[count++] = (ParetoPoint){at->numbers[SECONDS], at->numbers[ERROR]};
    }
    return count;
}
