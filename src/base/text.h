/* Growing text. */
#pragma once

#include "base/error.h"

#include <stddef.h>

/* Bytes that grow, always followed by a zero byte. A zeroed struct is empty. */
typedef struct Text {
    /* NULL while the text is empty. */
    char *data;
    size_t size, capacity;
} Text;

/* Makes room for `size` more bytes. */
void text_reserve(Text *text, size_t size);

void text_append(Text *text, const void *data, size_t size);
void text_print(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Appends a word so that a POSIX shell reads it back. The word is quoted only if it must be. */
void text_print_quoted(Text *text, const char *word);

/* Appends a command line. Each word is quoted if it must be. */
void text_print_command(Text *text, int count, char *const *words);

/* Returns the text as a string, "" if it is empty. */
const char *text_string(const Text *text);
void text_free(Text *text);
