/* A picture in memory: rows of linear RGBA float pixels, row 0 at the top, and layers beside them. */
#pragma once

#include "base/rectangle.h"

#include <stdbool.h>

/* What else is known of each pixel. Only EXR keeps it, in channels named by the layer and a letter:
 * "normal.X", or "Z" alone where the layer has no name. */
typedef struct ImageLayer {
    /* "normal"; may be "". */
    const char *name;
    /* A letter each: "XYZ". */
    const char *channels;
    /* strlen(channels) floats a pixel, in rows; owned by the image. */
    float *data;
} ImageLayer;

typedef struct Image {
    int width, height;
    /* 4 * width * height floats, owned. Alpha is 1 where a sample was taken, else 0. */
    float *rgba;
    /* Owned; none in a picture that was read. */
    ImageLayer *layers;
    int layer_count;
    /* The pixels that the file held or is to hold, if that is a part of the picture; the others are 0. Empty
     * if it is all. */
    Rectangle data;
    /* The pixels are light as it is shown, from 0 to 1, and not radiance. */
    bool shown;
} Image;

/* Whether the picture's file held that pixel. */
bool image_holds(const Image *image, int x, int y);

/* A zeroed picture. */
Image image_create(int width, int height);
void image_free(Image *image);

/* Adds a layer and gives its zeroed data, to be filled. The strings stay the caller's. */
float *image_add_layer(Image *image, const char *name, const char *channels);

/* The pixels that are held: `data`, or all. */
Rectangle image_window(const Image *image);

/* A picture of these pixels alone, without layers. */
Image image_crop(const Image *image, Rectangle window);
