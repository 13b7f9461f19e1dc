/* Growing text, strict number parsing, and "did you mean" lists. */
#pragma once

#include "base/error.h"

#include <stddef.h>

/* Growing bytes, always followed by a zero byte. A zeroed struct is empty. */
typedef struct Text {
    char *data; /* NULL while empty */
    size_t size, capacity;
} Text;

void text_append(Text *text, const void *data, size_t size);
void text_print(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends a word as a POSIX shell reads it back: as it stands where it can, else in quotes. */
void text_print_quoted(Text *text, const char *word);

/* Appends a command line, each word quoted as far as it needs to be. */
void text_print_command(Text *text, int count, char *const *words);

const char *text_string(const Text *text); /* "" while empty */
void text_free(Text *text);

/* Allocation that cannot be survived is not: these end the program with a message when memory is out. */
void *memory_get(size_t count, size_t size);             /* zeroed */
void *memory_grow(void *old, size_t count, size_t size); /* the new part is not zeroed */

/* The whole of `text` as a finite number, "1e-3" or "-2.5"; false if it is anything else. */
bool number_parse(const char *text, double *value);

/* The whole of `text` as a whole number of 0 to 2^53. */
bool count_parse(const char *text, unsigned long long *value);

/* As number_parse, with the error's words: "NAME: 'VALUE' is not a number from MIN to MAX". */
MUST_CHECK bool number_parse_range(const char *name, const char *text, double min, double max, double *value,
                                   Error *error);
