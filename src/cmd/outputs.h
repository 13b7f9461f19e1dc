/* Where a command writes its pictures: the files of -o, in the format of --format or of their endings. */
#pragma once

#include "cmd/options.h"
#include "image/image.h"
#include "image/write_params.h"

/* The format of one of the outputs, for image/format.h: --format, or NULL where the ending names it. */
const char *outputs_format(const Options *options, int index);

/* Checks all outputs before the work is done. If one is standard output, nothing else is printed there from
 * now on (base/descriptor.h). */
MUST_CHECK bool outputs_check(const Options *options, Error *error);

/* The same for files that hold no picture. */
MUST_CHECK bool outputs_check_text(const Options *options, Error *error);

/* Writes the picture to all outputs, each in its format. One that fails does not lose the others; the error
 * is that of the first. */
MUST_CHECK bool outputs_write(const Options *options, const Image *image, const ImageWriteParams *params,
                              Error *error);

/* "standard output" for "-", or the path. */
const char *outputs_name(const char *path);
