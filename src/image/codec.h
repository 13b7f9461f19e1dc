/* The formats, one file each. Encoders append the file's bytes to `out`; their errors do not know the path.
 * Decoders take the whole file, with its path for the errors; their params may be NULL. */
#pragma once

#include "base/text.h"
#include "image/image.h"
#include "image/read_params.h"
#include "image/write_params.h"

/* Decoders refuse more than this many columns, rows, or pixels in all: broken headers ask for anything. */
#define IMAGE_SIDE_MAX 65536
#define IMAGE_PIXELS_MAX (1L << 28)

MUST_CHECK bool exr_encode(const Image *image, const ImageWriteParams *params, Text *out, Error *error);
MUST_CHECK bool exr_decode(Image *image, const char *path, const Text *file, const ImageReadParams *params,
                           Error *error);
MUST_CHECK bool png_encode(const Image *image, const ImageWriteParams *params, Text *out, Error *error);
MUST_CHECK bool png_decode(Image *image, const char *path, const Text *file, const ImageReadParams *params,
                           Error *error);
void pfm_encode(const Image *image, Text *out);
MUST_CHECK bool pfm_decode(Image *image, const char *path, const Text *file, Error *error);
