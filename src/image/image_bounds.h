/* How much memory a picture that is read may take. */
#pragma once

#include "base/error.h"

#include <stddef.h>

/* Without a budget (base/budget.h), what any picture may take, and how much more for each byte of its file.
 */
#define IMAGE_MEMORY_FLOOR ((size_t)256 << 20)
#define IMAGE_MEMORY_FACTOR 64

/* Takes the memory for a picture of this size with `more` bytes beside its pixels, out of a file of
 * `file_size` bytes. Fails with STATUS_FAILURE and both numbers where it is more than may be taken. */
MUST_CHECK bool image_bounds_take(const char *path, size_t width, size_t height, size_t more,
                                  size_t file_size, Error *error);
