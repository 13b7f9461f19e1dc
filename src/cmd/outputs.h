/* Where a command writes its pictures: the files of -o, in the format of --format or of their endings. */
#pragma once

#include "cmd/options.h"

/* The format of one of the outputs, for image/format.h: --format, or NULL where the ending names it. */
const char *outputs_format(const Options *options, int index);

/* Checks all outputs before the work is done. If one is standard output, nothing else is printed there from
 * now on (base/descriptor.h). */
MUST_CHECK bool outputs_check(const Options *options, Error *error);

/* The same for files that hold no picture. */
MUST_CHECK bool outputs_check_text(const Options *options, Error *error);

/* "standard output" for "-", or the path. */
const char *outputs_name(const char *path);
