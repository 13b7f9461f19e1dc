/* Reads and writes whole files. */
#pragma once

#include "base/text.h"

/* What a reader takes at most, in bytes, and the status of its errors. */
typedef struct FileBounds {
    Status status;
    size_t most;
    /* If it is not NULL, it is asked once, as soon as the first bytes are there; if they are not those of the
     * right kind, nothing more is read. */
    bool (*begins_well)(const Text *start);
} FileBounds;

/* The most bytes of any file. */
#define FILE_MOST ((size_t)1 << 30)

/* Appends the whole of a regular file to `text`; everything else is refused (base/regular.h). The error says
 * why it could not be read, with `status`. */
MUST_CHECK bool file_read(const char *path, Status status, Text *text, Error *error);

/* The same for a file of `bounds->most` bytes at most. A larger one is refused before it is read. */
MUST_CHECK bool file_read_within(const char *path, const FileBounds *bounds, Text *text, Error *error);

/* The same for what is open already; `path` is its name for errors. */
MUST_CHECK bool file_read_open(int descriptor, const char *path, const FileBounds *bounds, Text *text,
                               Error *error);

/* Appends all that standard input has. */
MUST_CHECK bool file_read_input(const FileBounds *bounds, Text *text, Error *error);

/* Replaces the file at `path` by `size` bytes, at once or not at all. The bytes go into a temporary file
 * beside the target, which is renamed when it is complete; what killed processes left there for the same
 * target is removed (base/temporary.h). A symbolic link stays a link. A target that is no regular file (a
 * device, a pipe) is written in place, and what is open already (base/descriptor.h) goes on where it is.
 * Fails with STATUS_OUTPUT. */
MUST_CHECK bool file_replace(const char *path, const void *data, size_t size, Error *error);

/* Sets what is asked while a pipe waits for its reader: true ends the waiting, with an error. NULL is never.
 */
void file_set_stop(bool (*stop)(void));

/* Checks whether file_replace() could work, without touching anything. A mistyped folder is then found before
 * an hour of rendering. */
MUST_CHECK bool file_check_target(const char *path, Error *error);

/* True if the path exists and is not a regular file (a device, a pipe, a folder). */
bool file_is_special(const char *path);

/* True if the path is that of a terminal. */
bool file_is_terminal(const char *path);
