#include "error/adaptive.h"

#include "base/clock.h"
#include "base/memory.h"
#include "error/noise_figures.h"
#include "error/tile_plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    FIRST_SAMPLES = 4,
    /* All tiles get this number of samples before the plan begins. */
    EVEN_SAMPLES = 8,
    /* A plan made from fewer samples of a pixel, on average, is no reason to give up. */
    JUDGED_SAMPLES = 256,
    /* With evenly spread samples, the noise is not measured before this part of them (an eighth) is taken. */
    MEASURED_SHARE = 8
};

static int count_tiles(const Adaptive *adaptive) {
    return adaptive->noise.columns * adaptive->noise.rows;
}

Adaptive adaptive_create(const Renderer *renderer, NoiseMeasure measure, const ToneTable *tone) {
    Adaptive adaptive = {.noise = evidence_begin(renderer, tone), .measure = measure, .deadline = INFINITY};
    adaptive.wanted = memory_get((size_t)count_tiles(&adaptive), sizeof *adaptive.wanted);
    adaptive.regions = memory_get((size_t)count_tiles(&adaptive), sizeof *adaptive.regions);
    return adaptive;
}

void adaptive_destroy(Adaptive *adaptive) {
    noise_destroy(&adaptive->noise);
    free(adaptive->wanted);
    free(adaptive->regions);
    *adaptive = (Adaptive){0};
}

static double area_pixels(const Adaptive *adaptive) {
    return (double)adaptive->noise.area.width * adaptive->noise.area.height;
}

static double tile_pixels(const NoiseTile *tile) {
    return (double)tile->pixels.width * tile->pixels.height;
}

/* Chooses the tiles that are to be doubled, and whether the light paths are. Returns the number of choices.
 */
static int choose(Adaptive *adaptive, double target) {
    const Noise *noise = &adaptive->noise;
    int count = 0, tiles = count_tiles(adaptive);
    double planned = 0;
    int *doublings = memory_get((size_t)tiles, sizeof *doublings);
    int light = tile_plan(noise, adaptive->measure, target, doublings);
    adaptive->wanted_light = light ? noise->light.paths : 0;
    for (int i = 0; i < tiles; i++) {
        const NoiseTile *tile = &noise->tiles[i];
        bool chosen = doublings[i] > 0;
        adaptive->wanted[i] = chosen ? tile->samples : 0;
        count += chosen;
        planned += ldexp(tile_pixels(tile) * (double)tile->samples, doublings[i]);
    }
    free(doublings);
    adaptive->planned = (planned + ldexp(noise->light.paths, light)) / area_pixels(adaptive);
    return count + (light > 0);
}

/* Chooses all tiles that may have more samples, for a picture that has reached its target in too few paths to
 * say so. */
static void choose_all(Adaptive *adaptive) {
    for (int i = 0; i < count_tiles(adaptive); i++) {
        uint64_t samples = adaptive->noise.tiles[i].samples;
        adaptive->wanted[i] = 2 * samples <= TILE_MOST_SAMPLES ? samples : 0;
    }
}

/* Lists the tiles that are still to get from `least` to `most` samples as regions, and returns the number of
 * regions. Neighbours in a row are one region. */
static int make_regions(Adaptive *adaptive, uint64_t least, uint64_t most) {
    const Noise *noise = &adaptive->noise;
    int count = 0, run = -1;
    for (int i = 0; i < count_tiles(adaptive); i++) {
        const NoiseTile *tile = &noise->tiles[i];
        bool here = adaptive->wanted[i] >= least && adaptive->wanted[i] <= most;
        if (!here || i % noise->columns == 0) run = -1;
        if (!here) continue;
        if (run < 0) {
            run = count++;
            adaptive->regions[run] = tile->pixels;
        } else {
            adaptive->regions[run].width += tile->pixels.width;
        }
    }
    return count;
}

/* Returns the least number of samples that a tile is still to get, or UINT64_MAX if all tiles are done. */
static uint64_t fewest_wanted(const Adaptive *adaptive) {
    uint64_t fewest = UINT64_MAX;
    for (int i = 0; i < count_tiles(adaptive); i++) {
        if (adaptive->wanted[i] && adaptive->wanted[i] < fewest) fewest = adaptive->wanted[i];
    }
    return fewest;
}

/* Notes that all tiles that are not done got `taken` samples. */
static void count_samples(Adaptive *adaptive, uint64_t taken) {
    for (int i = 0; i < count_tiles(adaptive); i++) {
        NoiseTile *tile = &adaptive->noise.tiles[i];
        if (!adaptive->wanted[i]) continue;
        tile->samples += taken;
        adaptive->wanted[i] -= taken;
        adaptive->paths += taken * (uint64_t)tile_pixels(tile);
    }
}

static bool pauses(const Adaptive *adaptive) {
    return adaptive->pause && adaptive->pause();
}

/* Doubles the chosen tiles. Each draw gives a group of samples to all tiles that are not done. One draw of
 * many tiles keeps all cores busy; separate draws for each number of samples would not. */
static bool double_tiles(Adaptive *adaptive, Renderer *renderer, bool (*stop)(void), Error *error) {
    const Rectangle all = {0, 0, adaptive->noise.width, adaptive->noise.height};
    uint64_t fewest;
    film_keep(&renderer->film, &all, 1);
    /* `stop` is called here too, because a few small tiles are drawn in one piece. */
    while ((fewest = fewest_wanted(adaptive)) < UINT64_MAX && clock_seconds() < adaptive->deadline &&
           !(stop && stop())) {
        unsigned group =
            fewest < renderer->plan.group_samples ? (unsigned)fewest : renderer->plan.group_samples;
        bool stopped;
        int count = make_regions(adaptive, 1, UINT64_MAX);
        if (!renderer_refine(renderer, adaptive->regions, count, group, stop, &stopped, error)) return false;
        if (stopped) break;
        /* These tiles are done. */
        count = make_regions(adaptive, group, group);
        film_keep(&renderer->film, adaptive->regions, count);
        count_samples(adaptive, group);
        if (pauses(adaptive)) break;
    }
    return true;
}

/* Traces what the plan wants of light paths, when the tiles are done. */
static bool double_light(Adaptive *adaptive, Renderer *renderer, bool (*stop)(void), Error *error) {
    if (!(adaptive->wanted_light > 0) || fewest_wanted(adaptive) < UINT64_MAX ||
        clock_seconds() >= adaptive->deadline || (stop && stop()))
        return true;
    double before = renderer->film.light_paths;
    bool ok = renderer_light(renderer, (uint64_t)adaptive->wanted_light, stop, error);
    adaptive->wanted_light -= renderer->film.light_paths - before;
    return ok;
}

/* Notes that all tiles have the film's number of samples. */
static void set_samples(Adaptive *adaptive, const Film *film) {
    for (int i = 0; i < count_tiles(adaptive); i++) adaptive->noise.tiles[i].samples = film->samples;
    adaptive->paths = film->samples * (uint64_t)area_pixels(adaptive);
    adaptive->least = adaptive->most = film->samples;
}

/* Brings all tiles to the same number of samples, and their light paths with them. */
static bool sample_evenly(Adaptive *adaptive, Renderer *renderer, bool (*stop)(void), Error *error) {
    Film *film = &renderer->film;
    while (film->samples < adaptive->even && !(stop && stop() && film->samples)) {
        if (film->samples && clock_seconds() >= adaptive->deadline) break;
        if (!renderer_pass(renderer, adaptive->even - film->samples, stop, error)) return false;
        if (pauses(adaptive)) break;
    }
    set_samples(adaptive, film);
    return renderer_catch_up(renderer, stop, error);
}

static void find_range(Adaptive *adaptive) {
    adaptive->least = UINT64_MAX;
    adaptive->most = 0;
    for (int i = 0; i < count_tiles(adaptive); i++) {
        uint64_t samples = adaptive->noise.tiles[i].samples;
        if (samples < adaptive->least) adaptive->least = samples;
        if (samples > adaptive->most) adaptive->most = samples;
    }
}

static bool measure(Adaptive *adaptive, const Renderer *renderer, Error *error) {
    Image mean;
    FilmCount count;
    ChanceMap map;
    adaptive->claimed = evidence_suffices(&renderer->plan, adaptive->most, adaptive->paths);
    if (!evidence_is_there(&renderer->plan)) return true;
    if (!film_read(&renderer->film, &mean, &count, error)) return false;
    adaptive->rejected = film_rejected_share(&count);
    bool ok = chance_map_read(&map, &renderer->film, error);
    if (ok) {
        adaptive->evidence = evidence_gather(&adaptive->noise, &map, &mean);
        evidence_measure(&adaptive->noise, &renderer->film, &mean);
        chance_map_free(&map);
    }
    image_free(&mean);
    return ok;
}

/* Notes whether the plan that was made last is beyond what is done for a picture. */
static void judge_plan(Adaptive *adaptive) {
    double pixels = area_pixels(adaptive);
    bool judged = (double)adaptive->paths >= JUDGED_SAMPLES * pixels;
    bool beyond = judged && adaptive->planned > (double)ADAPTIVE_MOST_SAMPLES;
    adaptive->beyond = beyond ? adaptive->beyond + 1 : 0;
}

/* Notes whether a round has gone without a plan although the error is known, and without adding anything. */
static void judge_round(Adaptive *adaptive, const Renderer *renderer, bool stopped) {
    bool added = adaptive->paths > adaptive->paths_before ||
                 renderer->film.light_paths > adaptive->light_before || stopped;
    adaptive->aimless = !adaptive->chosen && adaptive->claimed ? adaptive->aimless + 1 : 0;
    adaptive->idle = !added;
}

/* Chooses what the next round does. */
static void begin_round(Adaptive *adaptive, const Renderer *renderer, double target) {
    uint64_t samples = renderer->film.samples;
    bool even = samples < EVEN_SAMPLES || !evidence_is_there(&renderer->plan);
    int chosen = even ? 0 : choose(adaptive, target);
    adaptive->chosen = chosen > 0;
    adaptive->paths_before = adaptive->paths;
    adaptive->light_before = renderer->film.light_paths;
    if (chosen) judge_plan(adaptive);
    /* If no tile is worth a doubling so early, as in a picture of the sky alone, all tiles get samples until
     * an error can be reported. */
    if (!chosen && adaptive->most == samples) even = true;
    if (!even && !chosen) choose_all(adaptive);
    adaptive->even = !even ? 0 : !samples ? FIRST_SAMPLES : 2 * samples;
    if (adaptive->even > TILE_MOST_SAMPLES) adaptive->even = samples;
    adaptive->under_way = true;
}

/* Whether the round has got all that it wanted. */
static bool is_complete(const Adaptive *adaptive, const Renderer *renderer) {
    if (adaptive->even) return renderer->film.samples >= adaptive->even && !renderer_is_behind(renderer);
    return fewest_wanted(adaptive) == UINT64_MAX && !(adaptive->wanted_light > 0);
}

/* Ends a round: measures the picture that there is. */
static bool end_round(Adaptive *adaptive, const Renderer *renderer, bool stopped, Error *error) {
    adaptive->under_way = false;
    adaptive->wanted_light = 0;
    for (int i = 0; i < count_tiles(adaptive); i++) adaptive->wanted[i] = 0;
    adaptive->rounds++;
    judge_round(adaptive, renderer, stopped);
    find_range(adaptive);
    return measure(adaptive, renderer, error);
}

bool adaptive_settle(Adaptive *adaptive, const Renderer *renderer, Error *error) {
    return !adaptive->under_way || end_round(adaptive, renderer, true, error);
}

bool adaptive_round(Adaptive *adaptive, Renderer *renderer, double target, bool (*stop)(void), Error *error) {
    if (!adaptive->under_way) begin_round(adaptive, renderer, target);
    if (adaptive->even ? !sample_evenly(adaptive, renderer, stop, error)
                       : !double_tiles(adaptive, renderer, stop, error) ||
                             !double_light(adaptive, renderer, stop, error)) {
        return false;
    }
    if (pauses(adaptive) && !is_complete(adaptive, renderer)) return true;
    bool stopped = (stop && stop()) || clock_seconds() >= adaptive->deadline;
    return end_round(adaptive, renderer, stopped, error);
}

bool adaptive_pass(Adaptive *adaptive, Renderer *renderer, uint64_t samples, bool (*stop)(void),
                   Error *error) {
    const Film *film = &renderer->film;
    bool ok = adaptive->under_way ? renderer_catch_up(renderer, stop, error)
                                  : renderer_pass(renderer, samples - film->samples, stop, error);
    if (!ok) return false;
    adaptive->under_way = false;
    set_samples(adaptive, film);
    if (pauses(adaptive) && renderer_is_behind(renderer)) {
        adaptive->under_way = true;
        return true;
    }
    bool doubling = film->samples && !(film->samples & (film->samples - 1));
    return !doubling || film->samples * MEASURED_SHARE < samples || measure(adaptive, renderer, error);
}
