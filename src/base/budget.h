/* The memory that this process may take for pictures. What a picture needs is computed from its sizes and
 * checked before anything is taken. */
#pragma once

#include "base/error.h"

#include <stddef.h>

/* Sets the budget (--max-memory); 0 is none. */
void budget_set(size_t bytes);

/* What is left of it; `usual` where there is none. */
size_t budget_left(size_t usual);

/* Takes `bytes` for `what`, which is kept to the end. Where they are more than is left, it fails with
 * `status` and both numbers; without a budget `usual` is allowed each time. */
MUST_CHECK bool budget_take(size_t bytes, size_t usual, Status status, const char *what, Error *error);

/* Gives back what was taken. */
void budget_give(size_t bytes);

/* A number of bytes for people, rounded up or down to whole KiB or MiB. */
typedef struct ByteWords {
    char text[32];
} ByteWords;
ByteWords bytes_up(size_t bytes);
ByteWords bytes_down(size_t bytes);
