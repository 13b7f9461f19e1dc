#include "error/tile_plan.h"

#include "base/memory.h"
#include "error/noise_figures.h"

#include <math.h>
#include <stdlib.h>

/* The plan looks this number of doublings ahead. */
enum { MOST_LEVELS = 24 };

/* The plan takes at least this share of the mean error of the tiles around a tile. Rare light, such as the
 * specks of a caustic, may have been found in a neighbour and not yet in the tile itself. */
static const double neighbours_share = 0.5;

/* What a light path costs, in samples of a pixel. Measured with glass and with metal: 2.4 to 4. */
static const double light_cost = 3;

/* What decides how often a tile is doubled. */
typedef struct TileNeed {
    /* The squared error of its samples, guarded by those of its neighbours, and the most that it may keep. */
    double error, limit;
} TileNeed;

static double tile_pixels(const NoiseTile *tile) {
    return (double)tile->pixels.width * tile->pixels.height;
}

static double tile_error(const Noise *noise, NoiseMeasure measure, const NoiseTile *tile) {
    return noise_of_samples(noise, tile, measure, (double)tile->samples);
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

/* The light paths, which all tiles share: their squared error, and how often they must be doubled at least so
 * that no tile exceeds its limit. */
typedef struct LightNeed {
    double error, paths;
    int least;
} LightNeed;

static LightNeed light_need(const Noise *noise, NoiseMeasure measure, const TileNeed *needs) {
    LightNeed need = {.paths = noise->light.paths};
    double most = 1;
    for (int i = 0; i < noise->columns * noise->rows; i++) {
        double error = noise_of_light(noise, &noise->tiles[i], measure, need.paths);
        need.error += error;
        if (needs[i].limit > 0) most = fmax(most, error / needs[i].limit);
    }
    need.least = (int)fmin(ceil(log2(most)), MOST_LEVELS);
    return need;
}

static int light_doublings(LightNeed need, double level) {
    int count = 0;
    while (count < MOST_LEVELS && (need.error / 2 > level * light_cost * need.paths || count < need.least)) {
        need.error /= 2;
        need.paths *= 2;
        count++;
    }
    return count;
}

typedef struct TilePlan {
    const Noise *noise;
    NoiseMeasure measure;
    TileNeed *needs;
    LightNeed light;
    int *doublings;
} TilePlan;

/* Plans the doublings that are worth `level`, and returns the squared error of the picture after them. The
 * needs decide which tiles are doubled. The result is computed from the tiles' own errors, as it will be
 * measured. */
static double plan_at(const TilePlan *plan, double level) {
    const Noise *noise = plan->noise;
    double fall = noise->figures[plan->measure].fall,
           sum = ldexp(plan->light.error, -light_doublings(plan->light, level));
    for (int i = 0; i < noise->columns * noise->rows; i++) {
        const NoiseTile *tile = &noise->tiles[i];
        plan->doublings[i] = doublings_of(tile, plan->needs[i], fall, level);
        sum += tile_error(noise, plan->measure, tile) * pow(fall, plan->doublings[i]);
    }
    return sum;
}

int tile_plan(const Noise *noise, NoiseMeasure measure, double target, int *doublings) {
    int tiles = noise->columns * noise->rows;
    double goal = noise_goal(noise, measure, target);
    /* Half of what a tile may keep is for light paths, if there are any. */
    double share = noise->light.paths > 0 ? 0.5 : 1;
    /* Bounds of the level. */
    double low = 1e-40, high = 1e40;
    TilePlan plan = {.noise = noise, .measure = measure, .doublings = doublings};
    plan.needs = memory_get((size_t)tiles, sizeof *plan.needs);
    for (int i = 0; i < tiles; i++)
        plan.needs[i] = (TileNeed){guarded_error(noise, measure, i),
                                   share * noise_tile_goal(&noise->tiles[i], measure, target)};
    plan.light = light_need(noise, measure, plan.needs);
    for (int i = 0; i < 100; i++) {
        double level = sqrt(low * high);
        if (plan_at(&plan, level) > goal) {
            high = level;
        } else {
            low = level;
        }
    }
    plan_at(&plan, low);
    free(plan.needs);
    return light_doublings(plan.light, low);
}
