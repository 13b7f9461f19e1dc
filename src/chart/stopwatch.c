#include "chart/stopwatch.h"

#include "base/clock.h"

#include <math.h>

static int index_of(uint64_t samples) {
    int index = 0;
    while (samples >> (index + 1) && index + 1 < STOPWATCH_SIZES) index++;
    return index;
}

bool stopwatch_start(Stopwatch *monitor, Renderer *renderer, Error *error) {
    *monitor = (Stopwatch){0};
    for (int i = 0; i < STOPWATCH_SIZES; i++) monitor->best[i] = INFINITY;
    bool ok = renderer_pass(renderer, 1, NULL, error);
    film_reset(&renderer->film);
    renderer->gl->Finish();
    return ok;
}

static bool time_pass(Stopwatch *monitor, Renderer *renderer, unsigned samples, Error *error) {
    double *best = &monitor->best[index_of(samples)];
    film_reset(&renderer->film);
    renderer->gl->Finish();
    double start = clock_seconds();
    if (!renderer_pass(renderer, samples, NULL, error)) return false;
    double seconds = clock_seconds() - start;
    *best = fmin(*best, seconds);
    monitor->spent += seconds;
    return true;
}

bool stopwatch_group(Stopwatch *monitor, Renderer *renderer, Error *error) {
    return time_pass(monitor, renderer, renderer->plan.group_samples, error);
}

bool stopwatch_sizes(Stopwatch *monitor, Renderer *renderer, Error *error) {
    for (unsigned samples = 1; samples <= renderer->plan.group_samples; samples *= 2) {
        if (!time_pass(monitor, renderer, samples, error)) return false;
    }
    return true;
}

double stopwatch_seconds(const Stopwatch *monitor, const Renderer *renderer, uint64_t samples) {
    uint64_t group = renderer->plan.group_samples;
    if (samples <= group) return monitor->best[index_of(samples)];
    return monitor->best[index_of(group)] * (double)samples / (double)group;
}
