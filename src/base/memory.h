/* Memory. */
#pragma once

#include <stddef.h>

/* None of the following ever returns NULL. When memory runs out it prints a message and ends the program. */

/* Returns zeroed memory. */
void *memory_get(size_t count, size_t size);

/* Returns `old` with a new size. The new part is not zeroed. */
void *memory_grow(void *old, size_t count, size_t size);

/* Returns a copy of a string, or of its first bytes, `length` at most. */
char *memory_string(const char *string);
char *memory_string_part(const char *string, size_t length);
