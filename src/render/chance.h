/* The light that a picture leaves to chance (gl/film.h): how much there is of it, and words for it. */
#pragma once

#include "gl/film.h"
#include "render/plan.h"

/* What a film with FILM_CHANCE holds, and the number of samples: 4 floats, 4 floats and 1 float a pixel. */
typedef struct ChanceMap {
    size_t pixels;
    float *chance, *squares, *samples;
} ChanceMap;

/* Reads the map. It is empty for a film without FILM_CHANCE. On success the caller frees it. */
MUST_CHECK bool chance_map_read(ChanceMap *map, const Film *film, Error *error);
void chance_map_free(ChanceMap *map);

/* Sets `mask` to 1 in the pixels in which the sun itself was seen in mirrors or glass. */
void chance_image_pixels(const ChanceMap *map, unsigned char *mask);

/* How much of a picture is left to chance, as shares from 0 to 1 of its paths, of its pixels and of its
 * light. `light` divides the light that is expected to be found only by luck by the picture's light with all
 * of it, whether or not the picture has found it yet. `materials` has a bit for each material that throws at
 * least a hundredth of that light. */
typedef struct ChanceShares {
    double paths, pixels, light;
    unsigned materials;
} ChanceShares;

/* All shares are 0 for an empty map. `mean` is the picture. */
ChanceShares chance_shares(const ChanceMap *map, const Image *mean);

/* Reads both the map and the picture, and returns the shares. */
MUST_CHECK bool chance_read_shares(ChanceShares *shares, const Film *film, const Image *mean, Error *error);

/* Whether the light left to chance deserves a warning: a thousandth of the picture's light or more. */
bool chance_matters(const ChanceShares *shares);

/* Writes the names of materials, given by bits, such as "glass and rough metal", for use in a sentence. */
void chance_throwers(unsigned materials, const SceneFacts *facts, char *text, size_t size);
