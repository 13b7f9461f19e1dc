#include "gl/film_light.h"

#include "base/memory.h"
#include "gl/texture.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static size_t pixel_count(const FilmLight *light) {
    return (size_t)light->width * (size_t)light->height;
}

FilmLight *film_light_create(const GlApi *gl, int width, int height) {
    FilmLight *light = memory_get(1, sizeof *light);
    *light = (FilmLight){.width = width, .height = height};
    light->sum = memory_get(4 * pixel_count(light), sizeof *light->sum);
    light->texture = texture_create(gl, width, height, GL_NEAREST, NULL);
    return light;
}

void film_light_destroy(FilmLight *light, const GlApi *gl) {
    if (!light) return;
    gl->DeleteTextures(1, &light->texture);
    free(light->sum);
    free(light);
}

void film_light_clear(FilmLight *light) {
    memset(light->sum, 0, 4 * pixel_count(light) * sizeof *light->sum);
    light->points = light->rejected = 0;
    light->current = false;
}

void film_light_add(FilmLight *light, const float *points, int count) {
    for (int i = 0; i < count; i++) {
        const float *point = points + 4 * (size_t)i;
        uint32_t bits;
        memcpy(&bits, point + 3, sizeof bits);
        int x = (int)(bits & 0x3fff), y = (int)(bits >> 14 & 0x3fff);
        if (x >= light->width || y >= light->height) continue;
        double *sum = light->sum + 4 * ((size_t)y * (size_t)light->width + (size_t)x), next[3];
        for (int c = 0; c < 3; c++) next[c] = sum[c] + (double)point[c];
        bool fits = fabs(next[0]) <= FLT_MAX && fabs(next[1]) <= FLT_MAX && fabs(next[2]) <= FLT_MAX;
        if (fits) memcpy(sum, next, sizeof next);
        light->points++;
        light->rejected += !fits;
        sum[3] += fits ? 0 : 1;
    }
    light->current = false;
}

GLuint film_light_texture(FilmLight *light, const GlApi *gl) {
    if (!light->current) {
        float *texels = memory_get(4 * pixel_count(light), sizeof *texels);
        for (size_t i = 0; i < 4 * pixel_count(light); i++) texels[i] = (float)light->sum[i];
        texture_resize(gl, light->texture, light->width, light->height, texels);
        free(texels);
    }
    light->current = true;
    return light->texture;
}

void film_light_archive(FilmLight *light, Archive *archive) {
    archive_bytes(archive, light->sum, 4 * pixel_count(light) * sizeof *light->sum);
    ARCHIVE(archive, light->points);
    ARCHIVE(archive, light->rejected);
    light->current = light->current && !archive_loads(archive);
}
