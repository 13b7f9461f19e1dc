#include "base/text.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void memory_out(void) {
    fputs("magichour: out of memory\n", stderr);
    exit(STATUS_FAILURE);
}

void *memory_get(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size ? size : 1);
    if (!memory) memory_out();
    return memory;
}

void *memory_grow(void *old, size_t count, size_t size) {
    if (size && count > SIZE_MAX / size) memory_out();
    size_t bytes = count * size;
    void *memory = realloc(old, bytes ? bytes : 1);
    if (!memory) memory_out();
    return memory;
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

bool number_parse(const char *text, double *value) {
    /* strtod alone would take "nan", "inf", hexadecimal and leading blanks. */
    if (!*text || strspn(text, "+-.0123456789eE") != strlen(text)) return false;
    char *end;
    double parsed = strtod(text, &end);
    if (end == text || *end || !isfinite(parsed)) return false;
    *value = parsed;
    return true;
}

bool count_parse(const char *text, unsigned long long *value) {
    if (!isdigit((unsigned char)*text)) return false;
    char *end;
    errno = 0;
    unsigned long long parsed = strtoull(text, &end, 10);
    if (*end || errno || parsed > 1ULL << 53) return false;
    *value = parsed;
    return true;
}

bool number_parse_range(const char *name, const char *text, double min, double max, double *value,
                        Error *error) {
    double parsed;
    if (!number_parse(text, &parsed) || parsed < min || parsed > max) {
        return error_set(error, STATUS_USAGE, "%s: '%s' is not a number from %g to %g", name, text, min, max);
    }
    *value = parsed;
    return true;
}
