#include "image/image.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

Image image_create(int width, int height) {
    return (Image){.width = width,
                   .height = height,
                   .rgba = memory_get((size_t)width * (size_t)height, 4 * sizeof(float))};
}

bool image_holds(const Image *image, int x, int y) {
    const Rectangle *data = &image->data;
    return !data->width ||
           (x >= data->x && x < data->x + data->width && y >= data->y && y < data->y + data->height);
}

float *image_add_layer(Image *image, const char *name, const char *channels) {
    size_t pixels = (size_t)image->width * (size_t)image->height;
    float *data = memory_get(pixels * strlen(channels), sizeof *data);
    image->layers = memory_grow(image->layers, (size_t)image->layer_count + 1, sizeof *image->layers);
    image->layers[image->layer_count++] = (ImageLayer){name, channels, data};
    return data;
}

void image_free(Image *image) {
    for (int i = 0; i < image->layer_count; i++) free(image->layers[i].data);
    free(image->layers);
    free(image->rgba);
    *image = (Image){0};
}
