#include "image/attribute.h"

#include "base/memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void attribute_add(AttributeList *list, const char *name, const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    size_t size = length > 0 ? (size_t)length + 1 : 1;
    char *value = memory_get(size, 1);
    vsnprintf(value, size, format, again);
    va_end(again);

    list->items = memory_grow(list->items, (size_t)list->count + 1, sizeof *list->items);
    list->items[list->count++] = (Attribute){memory_string(name), value};
}

void attribute_list_free(AttributeList *list) {
    for (int i = 0; i < list->count; i++) {
        free(list->items[i].name);
        free(list->items[i].value);
    }
    free(list->items);
    *list = (AttributeList){0};
}
