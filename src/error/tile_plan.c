#include "error/tile_plan.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* The plan looks this number of doublings ahead. */
enum { MOST_LEVELS = 24 };

/* The plan takes at least this share of the mean error of the tiles around a tile. Rare light, such as the
 * specks of a caustic, may have been found in a neighbour and not yet in the tile itself. */
static const double neighbours_share = 0.5;

/* What decides how often a tile is doubled. */
typedef struct TileNeed {
    /* Its squared error, guarded by those of its neighbours, and the most that it may keep. */
    double error, limit;
} TileNeed;

static double tile_pixels(const NoiseTile *tile) {
    return (double)tile->pixels.width * tile->pixels.height;
}

static double tile_error(const Noise *noise, NoiseMeasure measure, const NoiseTile *tile) {
    return noise_of_tile(noise, tile, measure, (double)tile->samples);
}

/* Returns the squared error of a tile that the plan uses. */
static double guarded_error(const Noise *noise, NoiseMeasure measure, int index) {
    int column = index % noise->columns, row = index / noise->columns;
    double around = 0, pixels = 0;
    for (int y = row - 1; y <= row + 1; y++) {
        for (int x = column - 1; x <= column + 1; x++) {
            if (x < 0 || y < 0 || x >= noise->columns || y >= noise->rows) continue;
            const NoiseTile *tile = &noise->tiles[y * noise->columns + x];
            /* The neighbour's error is scaled to the number of samples of tile `index`. */
            around += tile_error(noise, measure, tile) * (double)tile->samples /
                      (double)noise->tiles[index].samples;
            pixels += tile_pixels(tile);
        }
    }
    const NoiseTile *tile = &noise->tiles[index];
    return fmax(tile_error(noise, measure, tile), neighbours_share * around / pixels * tile_pixels(tile));
}

/* Returns how often a tile is to be doubled, if each doubling must remove at least `level` squared error a
 * sample. */
static int doublings_of(const NoiseTile *tile, TileNeed need, double fall, double level) {
    double cost = tile_pixels(tile) * (double)tile->samples;
    uint64_t samples = tile->samples;
    int count = 0;
    while (count < MOST_LEVELS && (need.error * (1 - fall) > level * cost || need.error > need.limit)) {
        samples *= 2;
        if (samples > TILE_MOST_SAMPLES) break;
        need.error *= fall;
        cost *= 2;
        count++;
    }
    return count;
}

/* Plans the doublings that are worth `level`, and returns the squared error of the picture after them. The
 * needs decide which tiles are doubled. The result is computed from the tiles' own errors, as it will be
 * measured. */
static double plan_at(const Noise *noise, NoiseMeasure measure, const TileNeed *needs, double level,
                      int *doublings) {
    double fall = noise->figures[measure].fall, sum = 0;
    for (int i = 0; i < noise->columns * noise->rows; i++) {
        const NoiseTile *tile = &noise->tiles[i];
        doublings[i] = doublings_of(tile, needs[i], fall, level);
        sum += tile_error(noise, measure, tile) * pow(fall, doublings[i]);
    }
    return sum;
}

void tile_plan(const Noise *noise, NoiseMeasure measure, double target, int *doublings) {
    int tiles = noise->columns * noise->rows;
    double goal = noise_goal(noise, measure, target);
    /* Bounds of the level. */
    double low = 1e-40, high = 1e40;
    TileNeed *needs = memory_get((size_t)tiles, sizeof *needs);
    for (int i = 0; i < tiles; i++)
        needs[i] =
            (TileNeed){guarded_error(noise, measure, i), noise_tile_goal(&noise->tiles[i], measure, target)};
    for (int i = 0; i < 100; i++) {
        double level = sqrt(low * high);
        if (plan_at(noise, measure, needs, level, doublings) > goal) {
            high = level;
        } else {
            low = level;
        }
    }
    plan_at(noise, measure, needs, low, doublings);
    free(needs);
}
