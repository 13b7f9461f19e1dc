#include "error/merge_noise.h"

#include "base/memory.h"
#include "error/evidence.h"
#include "error/noise_figures.h"
#include "image/sun_pixels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The area of a part whose pieces all have the same, or an empty one. */
static Rectangle area_of(const Part *part) {
    Rectangle area = part->pieces[0].area;
    for (int i = 1; i < part->piece_count; i++)
        if (!rectangle_same(&part->pieces[i].area, &area)) return (Rectangle){0};
    return area;
}

static int find_area(const MergeNoise *noise, const Rectangle *area) {
    for (int i = 0; i < noise->area_count; i++)
        if (rectangle_same(&noise->areas[i], area)) return i;
    return -1;
}

/* Notes the area of a part. Areas that overlap others, or pieces of several areas in one part, leave the
 * noise unknown. */
static void add_area(MergeNoise *noise, const Part *part) {
    Rectangle area = area_of(part);
    int known = find_area(noise, &area);
    if (known >= 0) noise->parts[known]++;
    if (known >= 0) return;
    noise->mixed |= !area.width;
    for (int i = 0; i < noise->area_count; i++)
        noise->mixed |= rectangle_overlap(&noise->areas[i], &area).width > 0;
    noise->parts[noise->area_count] = 1;
    noise->areas[noise->area_count++] = area;
}

bool merge_noise_create(MergeNoise *noise, const Merge *merge, Error *error) {
    size_t count = (size_t)merge->count;
    *noise = (MergeNoise){.areas = memory_get(count, sizeof *noise->areas),
                          .noises = memory_get(count, sizeof *noise->noises),
                          .parts = memory_get(count, sizeof *noise->parts),
                          .sun = memory_get((size_t)merge->width * (size_t)merge->height, 1)};
    for (int i = 0; i < merge->count; i++) {
        const char *sun = part_attribute(&merge->parts[i], SUN_PIXELS_ATTRIBUTE);
        add_area(noise, &merge->parts[i]);
        if (sun && !sun_pixels_parse(sun, noise->sun, merge->width, merge->height, error)) return false;
    }
    for (int i = 0; !noise->mixed && i < noise->area_count; i++) {
        noise->noises[i] = noise_create_area(merge->width, merge->height, noise->areas[i], NULL);
        noise_leave_out(&noise->noises[i], noise->sun);
    }
    return true;
}

void merge_noise_free(MergeNoise *noise) {
    for (int i = 0; i < noise->area_count; i++) noise_destroy(&noise->noises[i]);
    free(noise->areas);
    free(noise->noises);
    free(noise->parts);
    free(noise->sun);
    *noise = (MergeNoise){0};
}

/* A tile has as many samples as its pixel with the most. */
static void set_samples(Noise *noise, const MergeSums *sums) {
    for (int i = 0; i < noise_tile_count(noise); i++) {
        NoiseTile *tile = &noise->tiles[i];
        double most = 0;
        for (int k = 0; k < tile->pixels.width * tile->pixels.height; k++) {
            size_t pixel = noise_pixel(noise, &tile->pixels, k);
            most = fmax(most, sums->accepted[pixel] + sums->rejected[pixel]);
        }
        tile->samples = (uint64_t)most;
    }
}

void merge_noise_measure(MergeNoise *noise, const Part *part, const MergeSums *sums) {
    Rectangle area = area_of(part);
    int index = find_area(noise, &area);
    if (noise->mixed || index < 0 || noise->parts[index] < 2) return;
    Noise *here = &noise->noises[index];
    float *light;
    Image mean = merge_sums_mean(sums, &light);
    ChanceMap map = merge_sums_chance(sums);
    size_t first = (size_t)area.y * (size_t)sums->width + (size_t)area.x;
    NoisePicture picture = {
        .mean = &mean, .light = light, .light_paths = light ? sums->light_paths[first] : 0};
    if (!(picture.light_paths > 0)) picture.light = NULL;
    set_samples(here, sums);
    evidence_gather(here, &map, &mean);
    noise_measure(here, &picture);
    chance_map_free(&map);
    image_free(&mean);
    free(light);
}

/* The noise of an area of one part is what the part says of itself. */
static double own_percent(const Merge *merge, const Rectangle *area) {
    for (int i = 0; i < merge->count; i++) {
        Rectangle its = area_of(&merge->parts[i]);
        const char *text = part_attribute(&merge->parts[i], "magichour.noise_percent");
        if (rectangle_same(&its, area)) return text ? strtod(text, NULL) : INFINITY;
    }
    return INFINITY;
}

/* The mean of an area's pixels that are not left out, as noise.h has it. */
static double mean_of(const Noise *noise, const Image *image) {
    double sum = 0;
    size_t pixels = (size_t)noise->width * (size_t)noise->height;
    for (size_t i = 0; i < pixels; i++)
        for (size_t c = 0; !noise->left_out[i] && c < 3; c++) sum += (double)image->rgba[4 * i + c];
    return fmax(sum / (double)(noise->counted * 3), NOISE_LEAST_MEAN);
}

double merge_noise_percent(const MergeNoise *noise, const Merge *merge) {
    double squares = 0, sum = 0, counted = 0;
    uint64_t paths = merge->samples.accepted + merge->samples.rejected;
    if (noise->mixed || !evidence_is_enough(merge->whole.luck, merge->most, paths)) return INFINITY;
    for (int i = 0; i < noise->area_count; i++) {
        const Noise *here = &noise->noises[i];
        double mean = mean_of(here, &merge->image), pixels = (double)here->counted;
        double percent =
            noise->parts[i] > 1 ? noise_error(here, NOISE_RADIANCE) : own_percent(merge, &noise->areas[i]);
        squares += pow(percent * mean, 2) * pixels;
        sum += mean * pixels;
        counted += pixels;
    }
    return sqrt(squares / counted) / (sum / counted);
}

void merge_noise_calibrate(const MergeNoise *noise, float *variance) {
    for (int i = 0; !noise->mixed && i < noise->area_count; i++)
        if (noise->parts[i] > 1) noise_calibrate(&noise->noises[i], variance);
}
