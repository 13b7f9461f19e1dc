/* Reads and writes whole files. */
#pragma once

#include "base/text.h"

/* Appends the whole file to `text`. The error says why it could not be read, with `status`. */
MUST_CHECK bool file_read(const char *path, Status status, Text *text, Error *error);

/* Appends all that standard input has. */
MUST_CHECK bool file_read_input(Status status, Text *text, Error *error);

/* Replaces the file at `path` by `size` bytes, at once or not at all. The bytes go into a temporary file
 * beside the target, which is renamed when it is complete. A symbolic link stays a link. A target that is no
 * regular file (a device, a pipe) is written in place, and what is open already (base/descriptor.h) goes on
 * where it is. Fails with STATUS_OUTPUT. */
MUST_CHECK bool file_replace(const char *path, const void *data, size_t size, Error *error);

/* Checks whether file_replace() could work, without touching anything. A mistyped folder is then found before
 * an hour of rendering. */
MUST_CHECK bool file_check_target(const char *path, Error *error);

/* True if the path exists and is not a regular file (a device, a pipe, a folder). */
bool file_is_special(const char *path);

/* True if the path is that of a terminal. */
bool file_is_terminal(const char *path);
