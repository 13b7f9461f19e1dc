/* The difference of two pictures as the eye meets it: in 8-bit levels, after the tone curve, at an exposure.
 */
#pragma once

#include "image/image.h"
#include "image/tone.h"

#include <stddef.h>

/* Pixels in the side of a tile. Tiles are counted from the top left; those at the right and the bottom are
 * cut. A tile of fewer compared pixels is no tile of its own: the few would decide its figure by chance. */
enum { LEVELS_TILE = 16, LEVELS_TILE_LEAST = 64 };

/* The level that value i of the picture's `rgba` is shown as. The tone curve and the exposure are for
 * radiance; a picture that is light as it is shown needs none. */
double image_level(const Image *image, size_t i, Tone tone, double exposure_ev);

typedef struct Levels {
    /* The root mean square difference over the channels of all compared pixels. Infinite if there are none.
     */
    double rms;
    /* The same of the tile where it is largest, and that tile's first pixel. If no tile holds enough compared
     * pixels, the figure is that of all of them, and the pixel is 0,0. */
    double worst_tile;
    int worst_x, worst_y;
} Levels;

/* Compares the pixels in which `compared`, one byte a pixel, is not 0. The pictures have the same size. */
Levels levels_compare(const Image *a, const Image *b, const unsigned char *compared, Tone tone,
                      double exposure_ev);
