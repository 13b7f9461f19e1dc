/* What `info` says of a file that is no scene: a picture or a checkpoint. */
#pragma once

#include "base/error.h"

/* Whether the file is a picture or a checkpoint, by its first bytes. */
bool info_is_file(const char *path);

/* Prints what the file says of itself. */
MUST_CHECK bool info_print_file(const char *path, Error *error);
