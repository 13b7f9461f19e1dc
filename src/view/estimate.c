#include "view/estimate.h"

#include "error/noise_figures.h"

#include <math.h>

/* An error is known after three doublings, and is not claimed before 16 samples. */
static const uint64_t first_measure = 4;

/* Forgets what an unfinished measurement has read. */
static void stop(Estimate *estimate) {
    if (estimate->stage > ESTIMATE_FILM) image_free(&estimate->picture);
    if (estimate->stage > ESTIMATE_CHANCE) chance_map_free(&estimate->chance);
    estimate->stage = ESTIMATE_DONE;
}

void estimate_reset(Estimate *estimate) {
    stop(estimate);
    noise_destroy(&estimate->noise);
    estimate->error_percent = estimate->error_levels = estimate->worst_levels = NAN;
    estimate->chance_percent = 0;
}

void estimate_destroy(Estimate *estimate) {
    stop(estimate);
    noise_destroy(&estimate->noise);
}

static double known(double error) {
    return error < INFINITY ? error : NAN;
}

static void conclude(Estimate *estimate, const Renderer *renderer) {
    const Film *film = &renderer->film;
    const Noise *noise = &estimate->noise;
    double rms, worst;
    uint64_t paths = film->samples * (uint64_t)film->width * (uint64_t)film->height;
    bool claimed = evidence_suffices(&renderer->plan, film->samples, paths) && noise->largest > 0;
    noise_levels(noise, &rms, &worst);
    estimate->error_percent = claimed ? known(noise_error(noise, NOISE_RADIANCE)) : NAN;
    estimate->error_levels = claimed ? known(rms) : NAN;
    estimate->worst_levels = claimed ? known(worst) : NAN;
}

void estimate_begin(Estimate *estimate, const Renderer *renderer, double exposure_ev) {
    Noise *noise = &estimate->noise;
    uint64_t samples = renderer->film.samples;
    double gain = exp2(exposure_ev);
    ToneTable tone = tone_table(TONE_AUTHOR, gain);
    if (!noise->tiles) *noise = evidence_begin(renderer, &tone);
    noise_show(noise, gain);
    for (int i = 0; i < noise->columns * noise->rows; i++) noise->tiles[i].samples = samples;
    bool doubled = samples >= first_measure && !(samples & (samples - 1));
    if (doubled)
        estimate->stage = ESTIMATE_FILM;
    else
        conclude(estimate, renderer);
}

static void note_chance(Estimate *estimate) {
    ChanceShares chance = chance_shares(&estimate->chance, &estimate->picture);
    estimate->chance_percent = chance_matters(&chance) ? 100 * chance.light : 0;
}

bool estimate_step(Estimate *estimate, const Renderer *renderer, Error *error) {
    const Film *film = &renderer->film;
    FilmCount count;
    switch (estimate->stage) {
    case ESTIMATE_DONE:
        break;
    case ESTIMATE_FILM:
        if (!film_read(film, &estimate->picture, &count, error)) return false;
        estimate->stage = ESTIMATE_CHANCE;
        break;
    case ESTIMATE_CHANCE:
        if (!chance_map_read(&estimate->chance, film, error)) return false;
        estimate->stage = ESTIMATE_EVIDENCE;
        break;
    case ESTIMATE_EVIDENCE:
        note_chance(estimate);
        evidence_gather(&estimate->noise, &estimate->chance, &estimate->picture);
        estimate->stage = ESTIMATE_NOISE;
        break;
    case ESTIMATE_NOISE:
        evidence_measure(&estimate->noise, film, &estimate->picture);
        estimate->mean = estimate->noise.mean;
        stop(estimate);
        conclude(estimate, renderer);
        break;
    }
    return true;
}
