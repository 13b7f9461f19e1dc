/* Pictures in files. Each format has a codec in a file of its own, and only format.c knows them all. */
#pragma once

#include "base/error.h"
#include "image/image.h"
#include "image/read_params.h"
#include "image/write_params.h"

/* Whether the path's extension (.exr, .png, .pfm) names a format that can be written; STATUS_USAGE if not.
 * A device or pipe without an extension is given EXR. */
MUST_CHECK bool image_check_path(const char *path, Error *error);

/* Whether a picture written to this path keeps its layers. */
bool image_keeps_layers(const char *path);

/* Encodes by the path's extension and replaces the file (see file_replace). */
MUST_CHECK bool image_write(const Image *image, const char *path, const ImageWriteParams *params,
                            Error *error);

/* Reads EXR, PFM or PNG, told apart by content. A PNG is light as it is shown (Image.shown). Missing alpha
 * becomes 1; a luminance-only file becomes grey. `params` may be NULL. Fails with STATUS_FAILURE and leaves
 * an empty picture. */
MUST_CHECK bool image_read_as(Image *image, const char *path, const ImageReadParams *params, Error *error);

/* The same with default params. */
MUST_CHECK bool image_read(Image *image, const char *path, Error *error);

/* Appends the metadata of that name; false where there is no such file or line. PFM has none. */
bool image_attribute(const char *path, const char *name, Text *value);
