/* What the fuzz targets share: their inputs as files, in a folder that is removed at the end. */
#pragma once

#include "base/text.h"
#include "image/image.h"
#include "image/read_params.h"

#include <stddef.h>
#include <stdint.h>

/* Each target defines it; libFuzzer calls it. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Writes a file into the folder and gives its path, which is good until the next but seven calls. */
const char *input_file(const char *name, const uint8_t *data, size_t size);

/* A folder within the folder. */
void input_folder(const char *name);

/* The input's part up to the next line "===", which is skipped; `data` and `size` go on behind it. */
size_t input_part(const uint8_t **data, size_t *size, const uint8_t **part);

/* The bytes as a text. To be freed. */
Text input_text(const uint8_t *data, size_t size);

/* A decoder of image/codec.h. */
typedef bool InputDecoder(Image *image, const char *path, const Text *file, const ImageReadParams *params,
                          Error *error);

/* Reads a picture file and its metadata, with little memory. */
void input_picture(const uint8_t *data, size_t size, InputDecoder *decode);
