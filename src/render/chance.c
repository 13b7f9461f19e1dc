#include "render/chance.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool chance_map_read(ChanceMap *map, const Film *film, Error *error) {
    *map = (ChanceMap){0};
    if (!(film->parts & FILM_CHANCE)) return true;
    map->pixels = (size_t)film->width * (size_t)film->height;
    map->chance = memory_get(4 * map->pixels, sizeof(float));
    map->squares = memory_get(4 * map->pixels, sizeof(float));
    map->samples = memory_get(map->pixels, sizeof(float));
    if (film_read_chance(film, map->chance, map->squares, error) &&
        film_read_samples(film, map->samples, error)) {
        return true;
    }
    chance_map_free(map);
    return false;
}

void chance_map_free(ChanceMap *map) {
    free(map->chance);
    free(map->squares);
    free(map->samples);
    *map = (ChanceMap){0};
}

void chance_image_pixels(const ChanceMap *map, unsigned char *mask) {
    for (size_t i = 0; i < map->pixels; i++)
        mask[i] |= (unsigned)map->chance[4 * i + 3] >> FILM_CHANCE_IMAGE & 1;
}

static double luminance(const float *rgb) {
    return 0.2126 * (double)rgb[0] + 0.7152 * (double)rgb[1] + 0.0722 * (double)rgb[2];
}

/* Each pixel is divided by its own number of samples, because adaptive sampling gives some pixels more. */
ChanceShares chance_shares(const ChanceMap *map, const Image *mean) {
    ChanceShares shares = {0};
    double samples = 0, picture = 0, expected = 0, found = 0, thrown[FILM_CHANCE_MATERIALS] = {0};
    for (size_t i = 0; i < map->pixels; i++) {
        const float *c = map->chance + 4 * i;
        double weight = (double)map->samples[i];
        if (!(weight > 0)) continue;
        double light = (double)c[1] / weight;
        samples += weight;
        picture += luminance(mean->rgba + 4 * i);
        shares.paths += (double)c[0];
        shares.pixels += c[1] > 0 ? 1 : 0;
        expected += light;
        found += (double)c[2] / weight;
        for (int k = 0; k < FILM_CHANCE_MATERIALS; k++)
            if ((unsigned)c[3] >> k & 1) thrown[k] += light;
    }
    if (!(shares.paths > 0)) return shares;
    shares.paths /= samples;
    shares.pixels /= (double)map->pixels;
    if (expected > 0) shares.light = expected / (expected + fmax(picture - found, 0));
    for (int k = 0; k < FILM_CHANCE_MATERIALS; k++)
        if (thrown[k] > 0.01 * expected) shares.materials |= 1U << k;
    return shares;
}

bool chance_read_shares(ChanceShares *shares, const Film *film, const Image *mean, Error *error) {
    ChanceMap map;
    *shares = (ChanceShares){0};
    if (!chance_map_read(&map, film, error)) return false;
    *shares = chance_shares(&map, mean);
    chance_map_free(&map);
    return true;
}

bool chance_matters(const ChanceShares *shares) {
    return shares->light >= 1e-3;
}

/* Writes a material's name. For mirrors it says which ones, because only some leave light to chance. */
static void write_name(const char *name, char *text, size_t size) {
    bool mirror = strcmp(name, "mirror") == 0;
    snprintf(text, size, "%s", mirror ? "mirrors that the scene does not name or that stand in a row" : name);
    for (char *c = text; *c; c++) {
        if (*c == '_') *c = ' ';
    }
}

void chance_throwers(unsigned materials, const SceneFacts *facts, char *text, size_t size) {
    int left = 0;
    size_t used = 0;
    for (int i = 0; i < facts->material_count && i < FILM_CHANCE_MATERIALS; i++)
        left += (int)(materials >> i & 1);
    text[0] = 0;
    for (int i = 0; i < facts->material_count && i < FILM_CHANCE_MATERIALS && used < size; i++) {
        char name[80];
        if (!(materials >> i & 1)) continue;
        write_name(facts->materials[i], name, sizeof name);
        const char *comma = !used ? "" : left == 1 ? " and " : ", ";
        used += (size_t)snprintf(text + used, size - used, "%s%s", comma, name);
        left--;
    }
}
