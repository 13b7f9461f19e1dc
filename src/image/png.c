#include "base/memory.h"
#include "image/codec.h"

#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>

/* "lowbias32" by Chris Wellons: every bit of the input changes each bit of the result half of the time. */
static uint32_t hash(uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    return x ^ x >> 16;
}

/* Rounds a level, up as often as its fraction says: the mean over an area is right, and no bands show. 0 and
 * 255 have no fraction: they stay. */
static png_byte dither(double level, int x, int y, int channel) {
    uint32_t random = hash((uint32_t)x + hash((uint32_t)y + hash((uint32_t)channel + 1)));
    return (png_byte)fmin(level + random * 0x1p-32, 255);
}

/* A picture that is light as it is shown stays as it is. */
static void row_convert(const Image *image, int y, const ImageWriteParams *params, png_byte *row) {
    double gain = image->shown ? 1 : exp2(params->exposure_ev);
    Tone tone = image->shown ? TONE_NONE : params->tone;
    const float *pixel = image->rgba + 4 * (size_t)y * (size_t)image->width;
    for (int x = 0; x < image->width; x++, pixel += 4) {
        for (int c = 0; c < 3; c++) {
            *row++ = dither(tone_level(tone, gain, (double)pixel[c]), x, y, c);
        }
    }
}

static _Noreturn void png_fail(png_structp png, png_const_charp message) {
    error_set(png_get_error_ptr(png), STATUS_OUTPUT, "PNG: %s", message);
    png_longjmp(png, 1);
}

/* Without this, libpng prints warnings. */
static void png_ignore(png_structp png, png_const_charp message) {
    (void)png;
    (void)message;
}

static void bytes_append(png_structp png, png_bytep bytes, size_t size) {
    text_append(png_get_io_ptr(png), bytes, size);
}

static void bytes_flush(png_structp png) {
    (void)png;
}

static void attributes_set(png_structp png, png_infop info, const AttributeList *attributes) {
    for (int i = 0; attributes && i < attributes->count; i++) {
        /* The other kinds of text are Latin-1. Keys and texts are copied; the type is not const. */
        png_text chunk = {.compression = PNG_ITXT_COMPRESSION_NONE,
                          .key = (png_charp)attributes->items[i].name,
                          .text = attributes->items[i].value};
        png_set_text(png, info, &chunk, 1);
    }
}

/* False after png_fail. On its own, as the variables of a function that calls setjmp are not to be relied on.
 */
static bool png_run(png_structp png, png_infop info, const Image *image, const ImageWriteParams *params,
                    png_byte *row) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    attributes_set(png, info, params->attributes);
    png_write_info(png, info);
    for (int y = 0; y < image->height; y++) {
        row_convert(image, y, params, row);
        png_write_row(png, row);
    }
    png_write_end(png, NULL);
    return true;
}

bool png_encode(const Image *image, const ImageWriteParams *params, Text *out, Error *error) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, error, png_fail, png_ignore);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    bool encoded = false;
    if (info) {
        png_byte *row = memory_get((size_t)image->width, 3);
        png_set_write_fn(png, out, bytes_append, bytes_flush);
        encoded = png_run(png, info, image, params, row);
        free(row);
    } else {
        error_set(error, STATUS_OUTPUT, "PNG: libpng cannot be started");
    }
    png_destroy_write_struct(&png, &info);
    return encoded;
}
