#include "image/codec.h"
#include "image/image_bounds.h"
#include "image/png_attribute.h"

#include "base/memory.h"

#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* What is read, and how far. */
typedef struct PngSource {
    const Text *file;
    size_t at;
    const char *path;
    Error *error;
} PngSource;

static _Noreturn void png_fail(png_structp png, png_const_charp message) {
    PngSource *source = png_get_error_ptr(png);
    error_set(source->error, STATUS_FAILURE, "%s: broken PNG: %s", source->path, message);
    png_longjmp(png, 1);
}

/* Without this, libpng prints warnings. */
static void png_ignore(png_structp png, png_const_charp message) {
    (void)png;
    (void)message;
}

static void bytes_take(png_structp png, png_bytep bytes, size_t size) {
    PngSource *source = png_get_io_ptr(png);
    if (size > source->file->size - source->at) png_error(png, "it ends too early");
    memcpy(bytes, source->file->data + source->at, size);
    source->at += size;
}

/* Whether all chunks up to the last are as long as they claim: libpng takes memory for a text before it reads
 * it. */
static bool chunks_fit(const Text *file) {
    size_t at = 8;
    while (at <= file->size && file->size - at >= 12) {
        const unsigned char *chunk = (const unsigned char *)file->data + at;
        size_t length = (size_t)chunk[0] << 24 | (size_t)chunk[1] << 16 | (size_t)chunk[2] << 8 | chunk[3];
        if (length > file->size - at - 12) return false;
        if (memcmp(chunk + 4, "IEND", 4) == 0) return true;
        at += length + 12;
    }
    return false;
}

/* The header. False after png_fail. */
static bool header_read(png_structp png, png_infop info) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_user_limits(png, IMAGE_SIDE_MAX, IMAGE_SIDE_MAX);
    /* Texts and profiles, which may be packed a thousandfold. */
    png_set_chunk_malloc_max(png, 2 << 20);
    png_set_chunk_cache_max(png, 64);
    png_read_info(png, info);
    return true;
}

/* All rows as RGBA, of 8 or 16 bits a channel. False after png_fail. */
static bool rows_read(png_structp png, png_infop info, png_byte **rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_expand(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    png_read_image(png, rows);
    png_read_end(png, info);
    return true;
}

static void image_fill(Image *image, png_byte *const *rows, int depth) {
    for (int y = 0; y < image->height; y++) {
        float *pixel = image->rgba + 4 * (size_t)y * (size_t)image->width;
        for (size_t i = 0; i < 4 * (size_t)image->width; i++) {
            const png_byte *bytes = rows[y] + i * (size_t)(depth / 8);
            double share = depth == 16 ? (bytes[0] * 256 + bytes[1]) / 65535.0 : bytes[0] / 255.0;
            pixel[i] = (float)(i % 4 == 3 ? share : tone_light_of_level(255 * share));
        }
    }
}

/* Whether the file says that it is encoded otherwise than as sRGB. */
static bool is_other_gamma(png_structp png, png_infop info, double *gamma) {
    int intent;
    return !png_get_sRGB(png, info, &intent) && png_get_gAMA(png, info, gamma) &&
           fabs(*gamma * 2.2 - 1) > 0.05;
}

static bool picture_read(png_structp png, png_infop info, const PngSource *source, Image *image, Text *said) {
    if (!header_read(png, info)) return false;
    int64_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    int depth = png_get_bit_depth(png, info) == 16 ? 16 : 8;
    double gamma;
    if (width * height > IMAGE_PIXELS_MAX)
        return error_set(source->error, STATUS_FAILURE,
                         "%s: PNG of %lldx%lld: at most %ld pixels can be read", source->path,
                         (long long)width, (long long)height, IMAGE_PIXELS_MAX);
    if (is_other_gamma(png, info, &gamma))
        return error_set(source->error, STATUS_FAILURE, "%s: PNG with the gamma %g: only sRGB's can be read",
                         source->path, gamma);
    size_t row = 4 * (size_t)width * (size_t)(depth / 8);
    if (!image_bounds_take(source->path, (size_t)width, (size_t)height,
                           (row + sizeof(png_byte *)) * (size_t)height, source->file->size, source->error))
        return false;
    png_byte *bytes = memory_get((size_t)height, row);
    png_byte **rows = memory_get((size_t)height, sizeof *rows);
    for (int y = 0; y < height; y++) rows[y] = bytes + (size_t)y * row;
    bool read = rows_read(png, info, rows);
    if (read) {
        *image = image_create((int)width, (int)height);
        image->shown = true;
        image_fill(image, rows, depth);
        if (said)
            text_print(said, "PNG of %d bits, tone-mapped: compared as it is shown, in levels only\n", depth);
    }
    free(rows);
    free(bytes);
    return read;
}

bool png_decode(Image *image, const char *path, const Text *file, const ImageReadParams *params,
                Error *error) {
    *image = (Image){0};
    if (!chunks_fit(file)) return error_set(error, STATUS_FAILURE, "%s: broken PNG: it ends too early", path);
    PngSource source = {.file = file, .path = path, .error = error};
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, png_fail, png_ignore);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    bool read = false;
    if (info) {
        png_set_read_fn(png, &source, bytes_take);
        read = picture_read(png, info, &source, image, params ? params->said : NULL);
    } else {
        error_set(error, STATUS_FAILURE, "%s: PNG: libpng cannot be started", path);
    }
    png_destroy_read_struct(&png, &info, NULL);
    return read;
}

/* What to do with a file's metadata. */
typedef void TakeTexts(png_structp png, png_infop info, void *data);

/* Reads the header and the metadata in front of the pixels. */
static bool texts_read(const Text *file, TakeTexts *take, void *data) {
    Error ignored;
    if (!file->size || !chunks_fit(file)) return false;
    PngSource source = {.file = file, .path = "PNG", .error = &ignored};
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, png_fail, png_ignore);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    bool read = false;
    if (info) {
        png_set_read_fn(png, &source, bytes_take);
        read = header_read(png, info);
        if (read) take(png, info, data);
    }
    png_destroy_read_struct(&png, &info, NULL);
    return read;
}

typedef struct Search {
    const char *name;
    Text *value;
    bool found;
} Search;

static void text_find(png_structp png, png_infop info, void *data) {
    Search *search = data;
    png_textp texts;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    for (int i = 0; i < count && !search->found; i++) {
        if (strcmp(texts[i].key, search->name) != 0) continue;
        text_append(search->value, texts[i].text, strlen(texts[i].text));
        search->found = true;
    }
}

bool png_attribute(const Text *file, const char *name, Text *value) {
    Search search = {.name = name, .value = value};
    return texts_read(file, text_find, &search) && search.found;
}

static void texts_list(png_structp png, png_infop info, void *data) {
    Text *lines = data;
    png_textp texts;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    text_print(lines, "PNG of %ux%u, %d bits\n", png_get_image_width(png, info),
               png_get_image_height(png, info), png_get_bit_depth(png, info));
    for (int i = 0; i < count; i++) {
        char *line = texts[i].text;
        for (char *c = line; *c; c++)
            if ((unsigned char)*c < 32 || *c == 127) *c = ' ';
        text_print(lines, "%s: %s\n", texts[i].key, line);
    }
}

bool png_describe(const Text *file, Text *lines) {
    return texts_read(file, texts_list, lines);
}
