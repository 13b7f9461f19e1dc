/* What an EXR file asks for, before anything is taken for it. */
#pragma once

#include "base/text.h"

#include <openexr.h>

/* The most channels, attributes and parts of a file: OpenEXR's time grows with their squares. */
enum { EXR_CHANNELS_MOST = 4096, EXR_ATTRIBUTES_MOST = 4096, EXR_PARTS_MOST = 1024 };

/* Counts them in the file's bytes, before OpenEXR sees them. A file that is broken is left to OpenEXR. */
MUST_CHECK bool exr_bounds_count(const Text *file, const char *path, Error *error);

/* Checks the windows of a part, that the tables of chunks of all parts fit into the file, and that what has
 * to be unpacked is in proportion to it; then takes the memory for the picture. */
MUST_CHECK bool exr_bounds_take(exr_context_t exr, int part, const Text *file, const char *path,
                                Error *error);
