#include "cmd/nan_map.h"

#include "base/descriptor.h"
#include "base/memory.h"
#include "image/format.h"

#include <stdlib.h>
#include <string.h>

/* What gl/film.h counts, in the order of its channels. */
enum { NOT_FINITE, TOO_LARGE, LOOPS, NEGATIVE };

bool nan_map_check(const Options *options, Error *error) {
    const char *path = options->nan_map;
    if (!path) return true;
    if (descriptor_is_output(path))
        return error_set(error, STATUS_USAGE, "--nan-map: standard output is for the picture alone");
    if (!image_keeps_layers(path, NULL))
        return error_set(error, STATUS_USAGE, "--nan-map: %s is no .exr, and only .exr holds layers", path);
    for (int i = 0; i < options->output_count; i++) {
        if (strcmp(options->outputs[i], path) == 0)
            return error_set(error, STATUS_USAGE, "--nan-map: %s is the picture of -o already", path);
    }
    return image_check_target(path, NULL, error);
}

static void add_layer(Image *map, const char *name, const float *counts, size_t step) {
    float *layer = image_add_layer(map, name, "Y");
    for (size_t i = 0; i < (size_t)map->width * (size_t)map->height; i++) layer[i] = counts[step * i];
}

static void fill(Image *map, const float *counts, const float *points) {
    for (size_t i = 0; i < (size_t)map->width * (size_t)map->height; i++) {
        const float *count = counts + 4 * i;
        float *rgba = map->rgba + 4 * i;
        rgba[0] = count[NOT_FINITE];
        rgba[1] = count[TOO_LARGE] + count[LOOPS] + points[i];
        rgba[2] = count[NEGATIVE];
        rgba[3] = 1;
    }
    add_layer(map, "not_finite", counts + NOT_FINITE, 4);
    add_layer(map, "too_large", counts + TOO_LARGE, 4);
    add_layer(map, "loops", counts + LOOPS, 4);
    add_layer(map, "points", points, 1);
    add_layer(map, "negative", counts + NEGATIVE, 4);
}

bool nan_map_write(const RenderJob *job, const AttributeList *attributes, Error *error) {
    const Film *film = &job->renderer.film;
    if (!job->options->nan_map) return true;
    size_t pixels = (size_t)film->width * (size_t)film->height;
    float *counts = memory_get(4 * pixels, sizeof *counts), *points = memory_get(pixels, sizeof *points);
    Image map = image_create(film->width, film->height);
    bool ok = film_read_rejects(film, counts, error);
    film_read_points(film, points);
    if (ok) fill(&map, counts, points);
    ImageWriteParams params = {.attributes = attributes};
    ok = ok && image_write(&map, job->options->nan_map, &params, error);
    image_free(&map);
    free(counts);
    free(points);
    return ok;
}
