#include "error/evidence.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* Pixels that must have found a class. The error of an estimate from 50 specks is 10 % (noise.c). */
enum { ENOUGH_PIXELS = 50 };

/* The samples of a pixel, and the paths of a picture with light that is found by luck, before which an
 * estimate would be too uncertain. */
enum { ENOUGH_SAMPLES = 16, ENOUGH_PATHS = 1 << 20 };

Noise evidence_begin(const Renderer *renderer, const ToneTable *tone) {
    const Film *film = &renderer->film;
    Noise noise = noise_create_area(film->width, film->height, renderer->area, tone);
    unsigned char *sun = memory_get((size_t)film->width * (size_t)film->height, 1);
    sun_image_pixels(&renderer->sun_image, film->width, sun);
    noise_leave_out(&noise, sun);
    free(sun);
    return noise;
}

void evidence_measure(Noise *noise, const Film *film, const Image *mean) {
    NoisePicture picture = {.mean = mean};
    float *light = NULL;
    if (film->light_paths > 0) {
        light = memory_get((size_t)film->width * (size_t)film->height, 4 * sizeof *light);
        film_read_light(film, light);
        picture.light = light;
        picture.light_paths = film->light_paths;
    }
    noise_measure(noise, &picture);
    free(light);
}

static unsigned materials_near(const ChanceMap *map, size_t pixel) {
    return (unsigned)map->chance[4 * pixel + 3] & ((1U << FILM_CHANCE_MATERIALS) - 1);
}

static unsigned materials_met(const ChanceMap *map, size_t pixel) {
    return (unsigned)map->squares[4 * pixel + 3];
}

static unsigned find_unmet(const ChanceMap *map) {
    unsigned unmet = 0;
    for (int k = 0; k < FILM_CHANCE_MATERIALS; k++) {
        double near = 0, met = 0;
        for (size_t i = 0; i < map->pixels; i++) {
            near += materials_near(map, i) >> k & 1;
            met += materials_met(map, i) >> k & 1;
        }
        if (met < fmin(ENOUGH_PIXELS, near / 2)) unmet |= 1U << k;
    }
    return unmet;
}

/* The expected square of what the classes in `unmet` bring to a pixel in one sample. Materials that share a
 * component of `squares` are counted together. */
static double expected_square(const ChanceMap *map, size_t pixel, unsigned unmet) {
    unsigned here = unmet & materials_near(map, pixel);
    double sum = 0, samples = (double)map->samples[pixel];
    for (int slot = 0; slot < 3; slot++) {
        unsigned share = 0;
        for (int k = slot; k < FILM_CHANCE_MATERIALS; k += 3) share |= 1U << k;
        if (here & share) sum += (double)map->squares[4 * pixel + (size_t)slot];
    }
    return samples > 0 ? sum / samples : 0;
}

/* The expected squared change of the levels, times the samples. The light comes as specks: a sample brings
 * `speck` with a probability that makes its mean and its square right. One speck may take a pixel's level to
 * the end of the scale, and no further. */
static double expected_levels(const ChanceMap *map, size_t pixel, double square, const ToneTable *tone,
                              const float *mean) {
    double samples = (double)map->samples[pixel], light = (double)map->chance[4 * pixel + 1] / samples;
    if (!(square > 0) || !(light > 0)) return 0;
    double speck = square / light, probability = light / speck, sum = 0;
    for (int c = 0; c < 3; c++) {
        float with = (float)((double)mean[c] + speck / samples);
        double change = (double)tone_table_level(tone, with) - (double)tone_table_level(tone, mean[c]);
        sum += change * change / 3;
    }
    return samples * samples * probability * sum;
}

static void tell_noise(Noise *noise, const ChanceMap *map, unsigned unmet, const Image *mean) {
    for (int i = 0; i < noise->columns * noise->rows; i++) {
        NoiseTile *tile = &noise->tiles[i];
        const Rectangle *r = &tile->pixels;
        tile->change[NOISE_RADIANCE].unmet = tile->change[NOISE_LEVELS].unmet = 0;
        for (int k = 0; unmet && k < r->width * r->height; k++) {
            size_t pixel =
                (size_t)(r->y + k / r->width) * (size_t)noise->width + (size_t)(r->x + k % r->width);
            double square = noise->left_out[pixel] ? 0 : expected_square(map, pixel, unmet);
            tile->change[NOISE_RADIANCE].unmet += square;
            if (noise->tone)
                tile->change[NOISE_LEVELS].unmet +=
                    expected_levels(map, pixel, square, noise->tone, mean->rgba + 4 * pixel);
        }
    }
}

static void leave_out_sun(Noise *noise, const ChanceMap *map) {
    unsigned char *mask = memory_get(map->pixels, 1);
    chance_image_pixels(map, mask);
    noise_leave_out(noise, mask);
    free(mask);
}

Evidence evidence_gather(Noise *noise, const ChanceMap *map, const Image *mean) {
    Evidence evidence = {0};
    if (!map->pixels) return evidence;
    leave_out_sun(noise, map);
    evidence.unmet = find_unmet(map);
    tell_noise(noise, map, evidence.unmet, mean);
    for (size_t i = 0; i < map->pixels; i++)
        evidence.pixels += (evidence.unmet & materials_near(map, i)) != 0;
    evidence.pixels /= (double)map->pixels;
    ChanceShares shares = chance_shares(map, mean);
    evidence.thrown = chance_matters(&shares) ? shares.materials : 0;
    evidence.thrown_pixels = shares.pixels;
    return evidence;
}

bool evidence_is_there(const Plan *plan) {
    return !plan->sequence.method->walks_chains;
}

bool evidence_needs_luck(const Plan *plan) {
    return plan_counts_chance(plan) || plan->needs.emits;
}

bool evidence_is_enough(bool luck, uint64_t samples, uint64_t paths) {
    return samples >= ENOUGH_SAMPLES && (!luck || paths >= ENOUGH_PATHS);
}

bool evidence_suffices(const Plan *plan, uint64_t samples, uint64_t paths) {
    return evidence_is_there(plan) && evidence_is_enough(evidence_needs_luck(plan), samples, paths);
}
