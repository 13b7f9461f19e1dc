/* Growing text, memory, and strict parsing of numbers. */
#pragma once

#include "base/error.h"

#include <stddef.h>

/* Bytes that grow, always followed by a zero byte. A zeroed struct is empty. */
typedef struct Text {
    /* NULL while the text is empty. */
    char *data;
    size_t size, capacity;
} Text;

void text_append(Text *text, const void *data, size_t size);
void text_print(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends a word so that a POSIX shell reads it back. The word is quoted only if it must be. */
void text_print_quoted(Text *text, const char *word);

/* Appends a command line. Each word is quoted if it must be. */
void text_print_command(Text *text, int count, char *const *words);

/* Returns the text as a string, "" if it is empty. */
const char *text_string(const Text *text);
void text_free(Text *text);

/* The following two never return NULL. When memory runs out they print a message and end the program. */

/* Returns zeroed memory. */
void *memory_get(size_t count, size_t size);

/* Returns `old` with a new size. The new part is not zeroed. */
void *memory_grow(void *old, size_t count, size_t size);

/* Reads all of `text` as a finite number, such as "1e-3" or "-2.5". Returns false if it is anything else. */
bool number_parse(const char *text, double *value);

/* Reads all of `text` as a whole number from 0 to 2^53. Returns false if it is anything else. */
bool count_parse(const char *text, unsigned long long *value);

/* Reads a number as number_parse() does. Fails with "NAME: 'VALUE' is not a number from MIN to MAX". */
MUST_CHECK bool number_parse_range(const char *name, const char *text, double min, double max, double *value,
                                   Error *error);
