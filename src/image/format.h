/* Pictures in files. Each format has a codec in a file of its own, and only format.c knows them all. */
#pragma once

#include "base/error.h"
#include "image/image.h"
#include "image/read_params.h"
#include "image/write_params.h"

/* In what follows, `format` is "exr", "png" or "pfm". Where it is NULL, the path's ending (.exr, .png, .pfm)
 * names the format; a device or pipe without an ending is given EXR. */

/* Whether a picture can be written there: the format is known (STATUS_USAGE if not), the path is no terminal,
 * and file_check_target() finds no fault. */
MUST_CHECK bool image_check_target(const char *path, const char *format, Error *error);

/* Whether the path's ending names a format. */
bool image_knows_ending(const char *path);

/* Whether a picture written to this path keeps its layers. */
bool image_keeps_layers(const char *path, const char *format);

/* Encodes in `params->format` and replaces the file (see file_replace). */
MUST_CHECK bool image_write(const Image *image, const char *path, const ImageWriteParams *params,
                            Error *error);

/* Reads EXR, PFM or PNG, told apart by content. A PNG is light as it is shown (Image.shown). Missing alpha
 * becomes 1; a luminance-only file becomes grey. The path "-" is standard input. `params` may be NULL. Fails
 * with STATUS_FAILURE and leaves an empty picture. */
MUST_CHECK bool image_read_as(Image *image, const char *path, const ImageReadParams *params, Error *error);

/* The same with default params. */
MUST_CHECK bool image_read(Image *image, const char *path, Error *error);

/* Appends lines about a picture: its format and size, its channels, and its metadata as "name: value". Fails
 * with STATUS_FAILURE where the bytes are no picture that can be read. */
MUST_CHECK bool image_describe(const char *path, const Text *file, Text *lines, Error *error);

/* Whether a file that begins with these bytes is a picture: EXR, PNG or PFM. */
bool image_is_one(const Text *start);

/* Appends the metadata of that name, out of a file's bytes; false where there is no such line. PFM has none.
 */
bool image_attribute(const Text *file, const char *name, Text *value);
