#include "error/adaptive.h"

#include "base/clock.h"
#include "base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    FIRST_SAMPLES = 4,
    EVEN_SAMPLES = 8,     /* up to here all tiles get the same, and then what each is worth */
    CLAIMED_SAMPLES = 16, /* of the tile that has the most: nothing is claimed of fewer, too uncertain */
    MOST_LEVELS = 24,     /* of doublings to look ahead */
    MEASURED_SHARE = 8    /* of evenly spread samples, what comes before this part of them is not measured */
};

/* A tile is planned with no less than this share of the mean of the tiles around it: what is rare, such as a
 * caustic's specks, a neighbour may have met and the tile itself not yet. */
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

/* The tile's squared error to plan with. */
static double guarded_error(const Noise *noise, int index) {
    int column = index % noise->columns, row = index / noise->columns;
    double around = 0, pixels = 0;
    for (int y = row - 1; y <= row + 1; y++) {
        for (int x = column - 1; x <= column + 1; x++) {
            if (x < 0 || y < 0 || x >= noise->columns || y >= noise->rows) continue;
            const NoiseTile *tile = &noise->tiles[y * noise->columns + x];
            /* As if it had this one's samples. */
            around += tile_error(noise, tile) * (double)tile->samples / (double)noise->tiles[index].samples;
            pixels += tile_pixels(tile);
        }
    }
    const NoiseTile *tile = &noise->tiles[index];
    return fmax(tile_error(noise, tile), neighbours_share * around / pixels * tile_pixels(tile));
}

/* Doublings that are worth `level` squared error a sample to a tile of that error. */
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

/* The squared error of the picture once all is done that is worth `level`. Which tiles double is decided with
 * `guarded` errors, and what that brings is reckoned with their own, as it will be when it is measured. */
static double planned_error(const Noise *noise, const double *guarded, double level) {
    double sum = 0;
    for (int i = 0; i < noise->columns * noise->rows; i++) {
        const NoiseTile *tile = &noise->tiles[i];
        sum += tile_error(noise, tile) * pow(noise->fall, doublings(noise, tile, guarded[i], level));
    }
    return sum;
}

/* Chooses the tiles that are to double; how many. */
static int choose(Adaptive *adaptive, double percent) {
    const Noise *noise = &adaptive->noise;
    int count = 0, tiles = count_tiles(adaptive);
    double goal = noise_goal(noise, percent);
    double *guarded = memory_get((size_t)tiles, sizeof *guarded);
    double low = 1e-40, high = 1e40; /* of the level */
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

/* The tiles that want from `least` to `most` samples, runs of neighbours in a row as one. */
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

/* The fewest samples that any tile still wants; UINT64_MAX where none wants any. */
static uint64_t fewest_wanted(const Adaptive *adaptive) {
    uint64_t fewest = UINT64_MAX;
    for (int i = 0; i < count_tiles(adaptive); i++) {
        if (adaptive->wanted[i] && adaptive->wanted[i] < fewest) fewest = adaptive->wanted[i];
    }
    return fewest;
}

/* Writes down that the tiles that want samples got so many. */
static void count_samples(Adaptive *adaptive, uint64_t taken) {
    for (int i = 0; i < count_tiles(adaptive); i++) {
        NoiseTile *tile = &adaptive->noise.tiles[i];
        if (!adaptive->wanted[i]) continue;
        tile->samples += taken;
        adaptive->wanted[i] -= taken;
        adaptive->paths += taken * (uint64_t)tile_pixels(tile);
    }
}

/* Doubles the chosen tiles, group by group for all that want one still: one draw of many tiles keeps all
 * cores at work, where one for each number of samples would not. */
static bool double_tiles(Adaptive *adaptive, Renderer *renderer, bool (*stop)(void), Error *error) {
    const Rectangle all = {0, 0, adaptive->noise.width, adaptive->noise.height};
    uint64_t fewest;
    film_keep(&renderer->film, &all, 1);
    /* Few small tiles are drawn in one piece, within which nobody asks `stop`. */
    while ((fewest = fewest_wanted(adaptive)) < UINT64_MAX && clock_seconds() < adaptive->deadline &&
           !(stop && stop())) {
        unsigned group = fewest < renderer->group_samples ? (unsigned)fewest : renderer->group_samples;
        bool stopped;
        int count = make_regions(adaptive, 1, UINT64_MAX);
        if (!renderer_refine(renderer, adaptive->regions, count, group, stop, &stopped, error)) return false;
        if (stopped) break;
        count = make_regions(adaptive, group, group); /* those have all that they wanted */
        film_keep(&renderer->film, adaptive->regions, count);
        count_samples(adaptive, group);
    }
    return true;
}

/* All tiles have what the film has. */
static void set_samples(Adaptive *adaptive, const Film *film) {
    for (int i = 0; i < count_tiles(adaptive); i++) adaptive->noise.tiles[i].samples = film->samples;
    adaptive->paths = film->samples * (uint64_t)film->width * (uint64_t)film->height;
    adaptive->least = adaptive->most = film->samples;
}

/* The same for all tiles. */
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
    /* Where no tile is worth more so early, as in a picture of the sky alone, all get as many as are claimed
     * of. */
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
    /* What a few samples have not met, such as a lamp that is found by chance, would pass for done. */
    return adaptive->most < CLAIMED_SAMPLES ? INFINITY : noise_percent(&adaptive->noise);
}
