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

Rectangle image_window(const Image *image) {
    Rectangle all = {0, 0, image->width, image->height};
    return image->data.width > 0 && image->data.height > 0 ? image->data : all;
}

Image image_crop(const Image *image, Rectangle window) {
    Image cropped = image_create(window.width, window.height);
    cropped.shown = image->shown;
    for (int y = 0; y < window.height; y++) {
        size_t from = (size_t)(window.y + y) * (size_t)image->width + (size_t)window.x;
        memcpy(cropped.rgba + 4 * (size_t)y * (size_t)window.width, image->rgba + 4 * from,
               4 * sizeof *image->rgba * (size_t)window.width);
    }
    return cropped;
}
