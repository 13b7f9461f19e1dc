/* Opens files that somebody else may have made. */
#pragma once

#include "base/error.h"

#include <sys/stat.h>

/* Opens a regular file for reading. Whatever else has that name (a folder, a pipe, a device, a socket) is
 * refused at once: nothing waits, and nothing of it is read. Gives the descriptor, to be closed, and what
 * fstat() says of it; -1 with `status` and the reason where it cannot be read. */
int regular_open(const char *path, struct stat *found, Status status, Error *error);
