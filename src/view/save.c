#include "view/save.h"

#include "base/memory.h"
#include "base/version.h"
#include "image/format.h"
#include "image/sun_pixels.h"
#include "render/describe.h"
#include "view/command.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void save_choose_name(const Scene *scene, char *name, size_t size) {
    const char *slash = strrchr(scene->file->path, '/'), *stem = slash ? slash + 1 : scene->file->path;
    char path[512];
    for (int number = 1; number < 100000; number++) {
        snprintf(name, size, "%.*s-%03d", (int)strcspn(stem, "."), stem, number);
        snprintf(path, sizeof path, "%s.exr", name);
        if (access(path, F_OK) == 0) continue;
        snprintf(path, sizeof path, "%s.png", name);
        if (access(path, F_OK) != 0) return;
    }
}

static void add_layer(Image *image, const char *name, const Image *side) {
    float *data = image_add_layer(image, name, "RGB");
    size_t values = 3 * (size_t)side->width * (size_t)side->height;
    for (size_t i = 0; i < values; i++) data[i] = side->rgba[i / 3 * 4 + i % 3];
}

static void put_right(Image *image, const Image *right, int from) {
    for (int y = 0; y < image->height && from < image->width; y++) {
        size_t at = 4 * ((size_t)y * (size_t)image->width + (size_t)from);
        memcpy(image->rgba + at, right->rgba + at, 4 * (size_t)(image->width - from) * sizeof *image->rgba);
    }
}

static void subtract(Image *image, const Image *right) {
    size_t values = 4 * (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < values; i++) {
        if (i % 4 < 3) image->rgba[i] -= right->rgba[i];
    }
}

/* Puts the second side right of the divider, or the difference everywhere, and adds both sides as layers. */
static bool join(const SaveParams *params, Image *image, Error *error) {
    Image second;
    FilmCount count;
    if (!params->sides[1]) return true;
    if (!film_read(&params->sides[1]->renderer.film, &second, &count, error)) return false;
    if (second.width == image->width && second.height == image->height) {
        add_layer(image, "left", image);
        add_layer(image, "right", &second);
        if (params->difference > 0)
            subtract(image, &second);
        else
            put_right(image, &second, (int)round(params->divider * image->width));
    }
    image_free(&second);
    return true;
}

static void describe(const SaveParams *params, const FilmCount *count, AttributeList *list) {
    const Pane *pane = params->sides[0];
    Text command = {0};
    const CommandParams made = {params->scene, &pane->renderer, params->max_hits, params->glsl_dir};
    view_command(&made, &command);
    attribute_add(list, "magichour.version", "%s", MAGICHOUR_VERSION);
    attribute_add(list, "magichour.command", "%s", text_string(&command));
    attribute_add(list, "magichour.samples", "%" PRIu64, pane->renderer.film.samples);
    attribute_add(list, "magichour.depth", "%d", params->max_hits);
    attribute_add(list, "magichour.rejected", "%" PRIu64, count->rejected);
    attribute_add(list, "magichour.seconds", "%.6f", pane->seconds);
    const Noise *noise = &pane->estimate.noise;
    if (noise->tiles && !params->sides[1])
        sun_pixels_describe(noise->left_out, noise->width, noise->height, list);
    describe_picture(list, params->scene, &pane->renderer, params->context);
    if (params->sides[1]) {
        const Renderer *right = &params->sides[1]->renderer;
        attribute_add(
            list, "magichour.right", "sky %s, light %s, sequence %s, sun elevation %.9g azimuth %.9g",
            right->plan.sky.text, right->plan.light.text, right->plan.sequence.text,
            params->sides[1]->scene.values.sun.elevation_deg, params->sides[1]->scene.values.sun.azimuth_deg);
        if (params->difference > 0)
            attribute_add(list, "magichour.difference", "left - right, colours end at %.9g",
                          params->difference);
    }
    text_free(&command);
}

static bool write_file(const Image *image, const ImageWriteParams *params, const char *name,
                       const char *extension, Error *error) {
    char path[4200];
    snprintf(path, sizeof path, "%s.%s", name, extension);
    return image_write(image, path, params, error);
}

/* As in IEC 61966-2-1. */
static float linear_from_srgb(float v) {
    v = fminf(fmaxf(v, 0.0f), 1.0f);
    return v <= 0.04045f ? v / 12.92f : powf((v + 0.055f) / 1.055f, 2.4f);
}

/* These are the colours of glsl/pass/shown_difference.glsl in linear light. */
static void paint_difference(Image *image, double end) {
    static const float middle = 0.865f, blue[3] = {0.230f, 0.299f, 0.754f}, red[3] = {0.706f, 0.016f, 0.150f};
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) {
        float *rgb = image->rgba + 4 * i, t = (rgb[0] + rgb[1] + rgb[2]) / (3 * (float)end);
        for (int c = 0; c < 3; c++)
            rgb[c] = linear_from_srgb(middle + ((t < 0 ? blue : red)[c] - middle) * fminf(fabsf(t), 1.0f));
    }
}

bool save_picture(const SaveParams *params, const char *name, bool exr, Error *error) {
    AttributeList attributes = {0};
    ImageWriteParams write = {.exposure_ev = params->scene->values.exposure_ev, .attributes = &attributes};
    Image image;
    FilmCount count;
    if (!film_read(&params->sides[0]->renderer.film, &image, &count, error)) return false;
    describe(params, &count, &attributes);
    bool ok = join(params, &image, error) && (!exr || write_file(&image, &write, name, "exr", error));
    if (ok && params->difference > 0) {
        paint_difference(&image, params->difference);
        write = (ImageWriteParams){.tone = TONE_NONE, .attributes = &attributes};
    }
    ok = ok && write_file(&image, &write, name, "png", error);
    attribute_list_free(&attributes);
    image_free(&image);
    return ok;
}

bool save_texture(const Target *target, const char *path, const char *name, bool exr, Error *error) {
    AttributeList attributes = {0};
    ImageWriteParams write = {.tone = TONE_SCREEN, .attributes = &attributes};
    Image image = image_create(target->width, target->height);
    size_t row = 4 * (size_t)image.width;
    float *texels = memory_get(row * (size_t)image.height, sizeof *texels);
    bool ok = target_read(target, 0, texels, error);
    for (int y = 0; y < image.height; y++) {
        for (size_t i = 0; i < row; i++) {
            float v = texels[(size_t)(image.height - 1 - y) * row + i];
            image.rgba[(size_t)y * row + i] = i % 4 < 3 ? v : 1.0f;
        }
    }
    attribute_add(&attributes, "magichour.version", "%s", MAGICHOUR_VERSION);
    attribute_add(&attributes, "magichour.scene", "%s", path);
    ok = ok && (!exr || write_file(&image, &write, name, "exr", error)) &&
         write_file(&image, &write, name, "png", error);
    attribute_list_free(&attributes);
    image_free(&image);
    free(texels);
    return ok;
}
