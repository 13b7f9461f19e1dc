#include "base/number.h"
#include "image/codec.h"
#include "image/image_bounds.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* Bytes are put together by shifts, so that neither direction depends on this machine's byte order. */
static void float_append(Text *out, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    unsigned char bytes[4];
    for (int i = 0; i < 4; i++) bytes[i] = (unsigned char)(bits >> (8 * i) & 0xff);
    text_append(out, bytes, sizeof bytes);
}

static float float_load(const unsigned char *bytes, bool little_endian) {
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++) bits |= (uint32_t)bytes[i] << (8 * (little_endian ? i : 3 - i));
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

void pfm_encode(const Image *image, Text *out) {
    text_print(out, "PF\n%d %d\n-1.0\n", image->width, image->height);
    for (int y = image->height - 1; y >= 0; y--) {
        const float *row = image->rgba + 4 * (size_t)y * (size_t)image->width;
        for (int x = 0; x < image->width; x++) {
            for (int c = 0; c < 3; c++) float_append(out, row[4 * x + c]);
        }
    }
}

typedef struct PfmHeader {
    int width, height, channels;
    double scale; /* negative: little-endian; its size multiplies the values */
    size_t size;  /* bytes, up to the pixels */
} PfmHeader;

/* The word that starts at *at, ended by one blank, which is skipped: the pixels may begin with any byte. */
static bool word_take(const Text *file, size_t *at, char *word, size_t word_size) {
    size_t length = 0;
    while (*at + length < file->size && !strchr(" \t\r\n", file->data[*at + length])) length++;
    if (length == 0 || length >= word_size || *at + length == file->size) return false;
    memcpy(word, file->data + *at, length);
    word[length] = 0;
    *at += length + 1;
    return true;
}

static bool side_take(const Text *file, size_t *at, int *side) {
    char word[16];
    unsigned long long count;
    if (!word_take(file, at, word, sizeof word) || !count_parse(word, &count)) return false;
    if (count < 1 || count > IMAGE_SIDE_MAX) return false;
    *side = (int)count;
    return true;
}

static bool header_take(const Text *file, PfmHeader *header) {
    char word[32];
    size_t at = 0;
    if (!word_take(file, &at, word, sizeof word)) return false;
    header->channels = strcmp(word, "PF") == 0 ? 3 : strcmp(word, "Pf") == 0 ? 1 : 0;
    if (!header->channels) return false;
    if (!side_take(file, &at, &header->width) || !side_take(file, &at, &header->height)) return false;
    if ((long)header->width * header->height > IMAGE_PIXELS_MAX) return false;
    if (!word_take(file, &at, word, sizeof word) || !number_parse(word, &header->scale)) return false;
    if (header->scale == 0) return false;
    header->size = at;
    return true;
}

bool pfm_decode(Image *image, const char *path, const Text *file, Error *error) {
    *image = (Image){0};
    PfmHeader header;
    if (!header_take(file, &header)) {
        return error_set(
            error, STATUS_FAILURE,
            "%s: broken PFM header: 'PF' or 'Pf', width, height (at most %d, %ld pixels) and a scale "
            "other than 0 are expected",
            path, IMAGE_SIDE_MAX, IMAGE_PIXELS_MAX);
    }
    size_t row_size = (size_t)header.width * (size_t)header.channels * 4;
    size_t expected = row_size * (size_t)header.height;
    if (file->size - header.size != expected) {
        return error_set(error, STATUS_FAILURE, "%s: %s PFM: %zu bytes of pixels instead of %zu", path,
                         file->size - header.size < expected ? "truncated" : "overlong",
                         file->size - header.size, expected);
    }
    if (!image_bounds_take(path, (size_t)header.width, (size_t)header.height, 0, file->size, error))
        return false;

    *image = image_create(header.width, header.height);
    float scale = (float)fabs(header.scale);
    const unsigned char *bytes = (const unsigned char *)file->data + header.size;
    for (int y = header.height - 1; y >= 0; y--) {
        float *pixel = image->rgba + 4 * (size_t)y * (size_t)header.width;
        for (int x = 0; x < header.width; x++, pixel += 4, bytes += 4 * header.channels) {
            for (int c = 0; c < 3; c++) {
                float value = float_load(bytes + (header.channels == 3 ? 4 * c : 0), header.scale < 0);
                /* A multiplication by 1 would still change the bits of some NaNs. */
                pixel[c] = scale == 1 ? value : value * scale;
            }
            pixel[3] = 1;
        }
    }
    return true;
}
