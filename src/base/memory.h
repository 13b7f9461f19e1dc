/* Memory. */
#pragma once

#include <stddef.h>

/* The following two never return NULL. When memory runs out they print a message and end the program. */

/* Returns zeroed memory. */
void *memory_get(size_t count, size_t size);

/* Returns `old` with a new size. The new part is not zeroed. */
void *memory_grow(void *old, size_t count, size_t size);
