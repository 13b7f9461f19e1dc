#include "base/text.h"

#include "base/memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void text_reserve(Text *text, size_t size) {
    if (text->size + size + 1 <= text->capacity) return;
    text->capacity = text->size + size + 1;
    text->data = memory_grow(text->data, text->capacity, 1);
    text->data[text->size] = 0;
}

void text_append(Text *text, const void *data, size_t size) {
    if (text->size + size + 1 > text->capacity) {
        text->capacity = (text->size + size + 1) * 2;
        text->data = memory_grow(text->data, text->capacity, 1);
    }
    if (size) memcpy(text->data + text->size, data, size);
    text->size += size;
    text->data[text->size] = 0;
}

void text_print(Text *text, const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    if (length > 0) {
        char *line = memory_get((size_t)length + 1, 1);
        vsnprintf(line, (size_t)length + 1, format, again);
        text_append(text, line, (size_t)length);
        free(line);
    }
    va_end(again);
}

void text_print_quoted(Text *text, const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%+,-./:=@_";
    if (*word && !word[strspn(word, plain)]) {
        text_print(text, "%s", word);
        return;
    }
    text_append(text, "'", 1);
    for (const char *c = word; *c; c++) {
        /* Nothing has a meaning between single quotes but their end, so that a quote stands outside. */
        if (*c == '\'')
            text_print(text, "'\\''");
        else
            text_append(text, c, 1);
    }
    text_append(text, "'", 1);
}

void text_print_command(Text *text, int count, char *const *words) {
    for (int i = 0; i < count; i++) {
        if (i) text_append(text, " ", 1);
        text_print_quoted(text, words[i]);
    }
}

const char *text_string(const Text *text) {
    return text->data ? text->data : "";
}

void text_free(Text *text) {
    free(text->data);
    *text = (Text){0};
}
