#include "base/memory.h"

#include "base/error.h"

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

char *memory_string(const char *string) {
    return memory_string_part(string, strlen(string));
}

char *memory_string_part(const char *string, size_t length) {
    size_t there = strnlen(string, length);
    char *copy = memory_get(there + 1, 1);
    memcpy(copy, string, there);
    return copy;
}
