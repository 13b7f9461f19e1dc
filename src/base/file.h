/* Whole files in and out. */
#pragma once

#include "base/text.h"

/* Appends the whole file to `text`. The error says why it could not be read, with `status`. */
MUST_CHECK bool file_read(const char *path, Status status, Text *text, Error *error);

/* Replaces the file at `path` by `size` bytes, at once or not at all: they go into a temporary file beside
 * the target, which is renamed when it is whole. A symbolic link stays one; a target that is no regular file
 * (a device, a pipe) is written in place. Fails with STATUS_OUTPUT. */
MUST_CHECK bool file_replace(const char *path, const void *data, size_t size, Error *error);

/* Whether file_replace could work, without touching anything: so that a mistyped folder is found before
 * an hour's rendering. */
MUST_CHECK bool file_check_target(const char *path, Error *error);

/* True if the path exists and is not a regular file (a device, a pipe, a folder). */
bool file_is_special(const char *path);
