#include "image/exr_attribute.h"

#include "image/exr_stream.h"

#include <string.h>

bool exr_attribute(const Text *bytes, const char *name, Text *value) {
    exr_context_t file = NULL;
    ExrStream stream = {.in = bytes};
    exr_context_initializer_t settings = exr_settings(&stream);
    const exr_attribute_t *attribute = NULL;
    if (exr_start_read(&file, "EXR", &settings) != EXR_ERR_SUCCESS) return false;
    int parts = 0;
    bool found = false;
    if (exr_get_count(file, &parts) != EXR_ERR_SUCCESS) parts = 0;
    for (int part = 0; !found && part < parts; part++)
        found = exr_get_attribute_by_name(file, part, name, &attribute) == EXR_ERR_SUCCESS &&
                attribute->type == EXR_ATTR_STRING;
    if (found) text_append(value, attribute->string->str, (size_t)attribute->string->length);
    exr_finish(&file);
    return found;
}
