#include "error/noise_figures.h"
#include "image/levels.h"

#include <math.h>

/* What the worst tile may have for each level of the picture. */
static const double tile_share = 2;

double noise_of_samples(const Noise *noise, const NoiseTile *tile, NoiseMeasure measure, double samples) {
    const NoiseFigures *figures = &noise->figures[measure];
    if (tile->times < 2 || !noise_measures(noise, measure)) return INFINITY;
    double levels = log2(samples / (double)tile->measured), change = tile->change[measure].now;
    /* The change before, multiplied by q, estimates the same value. The mean of both has less noise of its
     * own, and so fewer tiles seem to be done too early. */
    if (tile->times > 2) change = 0.5 * (change + figures->measured_fall * tile->change[measure].earlier);
    return change * figures->fall / (1 - figures->fall) * noise_fallen(figures, levels) +
           tile->change[measure].unmet / samples;
}

/* The change between n / 2 and n independent paths is the variance of n. */
double noise_of_light(const Noise *noise, const NoiseTile *tile, NoiseMeasure measure, double paths) {
    if (!(paths > 0)) return 0;
    if (noise->light.times < 2 || !noise_measures(noise, measure)) return INFINITY;
    return tile->light[measure].now * noise->light.measured / paths;
}

double noise_of_tile(const Noise *noise, const NoiseTile *tile, NoiseMeasure measure, double samples) {
    return noise_of_samples(noise, tile, measure, samples) +
           noise_of_light(noise, tile, measure, noise->light.paths);
}

static double whole_error(const Noise *noise, NoiseMeasure measure) {
    double sum = 0;
    for (int i = 0; i < noise_tile_count(noise); i++)
        sum += noise_of_tile(noise, &noise->tiles[i], measure, (double)noise->tiles[i].samples);
    return sum;
}

static double tile_caution(const NoiseTile *tile) {
    const NoiseChange *change = &tile->change[NOISE_LEVELS], *light = &tile->light[NOISE_LEVELS];
    return noise_caution(NOISE_LEVELS, change->now + light->now, change->squares + light->squares);
}

void noise_levels(const Noise *noise, double *rms, double *worst_tile) {
    double sum = whole_error(noise, NOISE_LEVELS), worst = -1;
    *rms = *worst_tile = INFINITY;
    if (!(sum < INFINITY)) return;
    *rms = noise->figures[NOISE_LEVELS].caution * sqrt(sum / (double)noise->counted);
    for (int i = 0; i < noise_tile_count(noise); i++) {
        const NoiseTile *tile = &noise->tiles[i];
        if (tile->counted < LEVELS_TILE_LEAST) continue;
        double error = noise_of_tile(noise, tile, NOISE_LEVELS, (double)tile->samples);
        worst = fmax(worst, tile_caution(tile) * sqrt(error / tile->counted));
    }
    *worst_tile = worst < 0 ? *rms : worst;
}

double noise_error(const Noise *noise, NoiseMeasure measure) {
    if (measure == NOISE_LEVELS) {
        double rms, worst;
        noise_levels(noise, &rms, &worst);
        return fmax(rms, worst / tile_share);
    }
    double sum = whole_error(noise, measure);
    if (!(sum < INFINITY)) return INFINITY;
    return sum > 0 ? noise->figures[measure].caution * 100 * sqrt(sum / (double)noise->counted) / noise->mean
                   : 0;
}

double noise_goal(const Noise *noise, NoiseMeasure measure, double error) {
    double unit = measure == NOISE_RADIANCE ? noise->mean : 1;
    if (measure == NOISE_RADIANCE) error *= 0.01;
    return pow(error / noise->figures[measure].caution * unit, 2) * (double)noise->counted;
}

double noise_tile_goal(const NoiseTile *tile, NoiseMeasure measure, double error) {
    if (measure == NOISE_RADIANCE || tile->counted < LEVELS_TILE_LEAST) return INFINITY;
    return pow(tile_share * error / tile_caution(tile), 2) * tile->counted;
}

static void calibrate_tile(const Noise *noise, const NoiseTile *tile, float *variance) {
    const Rectangle *r = &tile->pixels;
    double sum = 0, error = noise_of_tile(noise, tile, NOISE_RADIANCE, (double)tile->samples);
    for (int pass = 0; pass < 2; pass++) {
        for (int k = 0; k < 3 * r->width * r->height; k++) {
            size_t pixel = noise_pixel(noise, r, k / 3);
            float *value = &variance[3 * pixel + (size_t)(k % 3)];
            if (noise->left_out[pixel]) continue;
            if (pass == 0) sum += (double)*value / 3;
            if (pass == 1 && sum > 0 && error < INFINITY) *value = (float)(*value * error / sum);
        }
    }
}

void noise_calibrate(const Noise *noise, float *variance) {
    for (int i = 0; i < noise_tile_count(noise); i++) calibrate_tile(noise, &noise->tiles[i], variance);
}
