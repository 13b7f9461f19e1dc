#include "error/adaptive.h"

#include "base/clock.h"
#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    FIRST_SAMPLES = 4,
    /* All tiles get this number of samples before the plan begins. */
    EVEN_SAMPLES = 8,
    /* No error is reported before one tile has this number of samples, because the estimate would be too
     * uncertain. */
    CLAIMED_SAMPLES = 16,
    /* The plan looks this number of doublings ahead. */
    MOST_LEVELS = 24,
    /* With evenly spread samples, the noise is not measured before this part of them (an eighth) is taken. */
    MEASURED_SHARE = 8
};

/* The plan takes at least this share of the mean error of the tiles around a tile. Rare light, such as the
 * specks of a caustic, may have been found in a neighbour and not yet in the tile itself. */
static const double neighbours_share = 0.5;

static int count_tiles(const Adaptive *adaptive) {
    return adaptive->noise.columns * adaptive->noise.rows;
}

Adaptive adaptive_create(const Renderer *renderer, double trim) {
    Adaptive adaptive = {.noise = noise_create(renderer->film.width, renderer->film.height, trim),
                         .deadline = INFINITY};
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

static double tile_pixels(const NoiseTile *tile) {
    return (double)tile->pixels.width * tile->pixels.height;
}

static double tile_error(const Noise *noise, const NoiseTile *tile) {
    return noise_of_tile(noise, tile, (double)tile->samples);
}

/* Returns the squared error of a tile that the plan uses. */
static double guarded_error(const Noise *noise, int index) {
    int column = index % noise->columns, row = index / noise->columns;
    double around = 0, pixels = 0;
    for (int y = row - 1; y <= row + 1; y++) {
        for (int x = column - 1; x <= column + 1; x++) {
            if (x < 0 || y < 0 || x >= noise->columns || y >= noise->rows) continue;
            const NoiseTile *tile = &noise->tiles[y * noise->columns + x];
            /* The neighbour's error is scaled to the number of samples of tile `index`. */
            around += tile_error(noise, tile) * (double)tile->samples / (double)noise->tiles[index].samples;
            pixels += tile_pixels(tile);
        }
    }
    const NoiseTile *tile = &noise->tiles[index];
    return fmax(tile_error(noise, tile), neighbours_share * around / pixels * tile_pixels(tile));
}

/* Returns how often a tile is to be doubled, if it has the squared error `error` and each doubling must
 * remove at least `level` squared error a sample. */
static int doublings(const Noise *noise, const NoiseTile *tile, double error, double level) {
    double cost = tile_pixels(tile) * (double)tile->samples;
    int count = 0;
    while (count < MOST_LEVELS && error * (1 - noise->fall) > level * cost) {
        error *= noise->fall;
        cost *= 2;
        count++;
    }
    return count;
}

/* Returns the squared error of the picture after all doublings that are worth `level`. The `guarded` errors
 * decide which tiles are doubled. The result is computed from the tiles' own errors, as it will be measured.
 */
static double planned_error(const Noise *noise, const double *guarded, double level) {
    double sum = 0;
    for (int i = 0; i < noise->columns * noise->rows; i++) {
        const NoiseTile *tile = &noise->tiles[i];
        sum += tile_error(noise, tile) * pow(noise->fall, doublings(noise, tile, guarded[i], level));
    }
    return sum;
}

/* Chooses the tiles that are to be doubled, and returns their number. */
static int choose(Adaptive *adaptive, double percent) {
    const Noise *noise = &adaptive->noise;
    int count = 0, tiles = count_tiles(adaptive);
    double goal = noise_goal(noise, percent);
    double *guarded = memory_get((size_t)tiles, sizeof *guarded);
    /* Bounds of the level. */
    double low = 1e-40, high = 1e40;
    for (int i = 0; i < tiles; i++) guarded[i] = guarded_error(noise, i);
    for (int i = 0; i < 100; i++) {
        double level = sqrt(low * high);
        if (planned_error(noise, guarded, level) > goal) {
            high = level;
        } else {
            low = level;
        }
    }
    for (int i = 0; i < tiles; i++) {
        bool chosen = doublings(noise, &noise->tiles[i], guarded[i], low) > 0;
        adaptive->wanted[i] = chosen ? noise->tiles[i].samples : 0;
        count += chosen;
    }
    free(guarded);
    return count;
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
    }
    return true;
}

/* Notes that all tiles have the film's number of samples. */
static void set_samples(Adaptive *adaptive, const Film *film) {
    for (int i = 0; i < count_tiles(adaptive); i++) adaptive->noise.tiles[i].samples = film->samples;
    adaptive->paths = film->samples * (uint64_t)film->width * (uint64_t)film->height;
    adaptive->least = adaptive->most = film->samples;
}

/* Gives the same number of samples to all tiles. */
static bool sample_evenly(Adaptive *adaptive, Renderer *renderer, bool (*stop)(void), Error *error) {
    Film *film = &renderer->film;
    uint64_t before = film->samples, wanted = before ? before : FIRST_SAMPLES;
    while (film->samples - before < wanted && !(stop && stop() && film->samples)) {
        if (film->samples && clock_seconds() >= adaptive->deadline) break;
        if (!renderer_pass(renderer, wanted - (film->samples - before), stop, error)) return false;
    }
    set_samples(adaptive, film);
    return true;
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
    if (!film_read(&renderer->film, &mean, &count, error)) return false;
    noise_measure(&adaptive->noise, &mean);
    image_free(&mean);
    return true;
}

bool adaptive_round(Adaptive *adaptive, Renderer *renderer, double percent, bool (*stop)(void),
                    Error *error) {
    /* If no tile is worth a doubling so early, as in a picture of the sky alone, all tiles get samples until
     * an error can be reported. */
    bool even = renderer->film.samples < EVEN_SAMPLES ||
                (!choose(adaptive, percent) && adaptive->most < CLAIMED_SAMPLES);
    if (even) {
        if (!sample_evenly(adaptive, renderer, stop, error)) return false;
    } else if (!double_tiles(adaptive, renderer, stop, error)) {
        return false;
    }
    adaptive->rounds++;
    find_range(adaptive);
    return measure(adaptive, renderer, error);
}

bool adaptive_pass(Adaptive *adaptive, Renderer *renderer, uint64_t samples, bool (*stop)(void),
                   Error *error) {
    const Film *film = &renderer->film;
    if (!renderer_pass(renderer, samples - film->samples, stop, error)) return false;
    set_samples(adaptive, film);
    bool doubling = film->samples && !(film->samples & (film->samples - 1));
    return !doubling || film->samples * MEASURED_SHARE < samples || measure(adaptive, renderer, error);
}

double adaptive_percent(const Adaptive *adaptive) {
    /* Light that few samples find, such as that of a lamp without a hint, would be missed by an earlier
     * estimate. */
    return adaptive->most < CLAIMED_SAMPLES ? INFINITY : noise_percent(&adaptive->noise);
}
