#include "image/exr_attribute.h"

#include "image/exr_bounds.h"
#include "image/exr_stream.h"

#include <string.h>

/* Opens what is within the bounds; to be finished. */
static bool begin(exr_context_t *file, ExrStream *stream) {
    Error ignored;
    if (!exr_bounds_count(stream->in, "EXR", &ignored)) return false;
    exr_context_initializer_t settings = exr_settings(stream);
    return exr_start_read(file, "EXR", &settings) == EXR_ERR_SUCCESS;
}

bool exr_attribute(const Text *bytes, const char *name, Text *value) {
    exr_context_t file = NULL;
    ExrStream stream = {.in = bytes};
    const exr_attribute_t *attribute = NULL;
    if (!begin(&file, &stream)) return false;
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

/* Appends a file's own words as one line that a terminal can show. */
static void print_clean(Text *lines, const char *words, size_t length) {
    for (size_t i = 0; i < length; i++) {
        bool plain = (unsigned char)words[i] >= 32 && words[i] != 127;
        text_append(lines, plain ? words + i : " ", 1);
    }
}

static void describe_windows(exr_context_t file, int part, Text *lines) {
    exr_attr_box2i_t data, display;
    if (exr_get_data_window(file, part, &data) || exr_get_display_window(file, part, &display)) return;
    text_print(lines, "EXR of %lldx%lld", (long long)display.max.x - display.min.x + 1,
               (long long)display.max.y - display.min.y + 1);
    if (memcmp(&data, &display, sizeof data) != 0)
        text_print(lines, ", of which it holds %lldx%lld at %lld,%lld",
                   (long long)data.max.x - data.min.x + 1, (long long)data.max.y - data.min.y + 1,
                   (long long)data.min.x - display.min.x, (long long)data.min.y - display.min.y);
}

static void describe_channels(exr_context_t file, int part, Text *lines) {
    const exr_attr_chlist_t *list = NULL;
    if (exr_get_channels(file, part, &list)) return;
    text_print(lines, ", channels");
    for (int i = 0; i < list->num_channels; i++) {
        text_print(lines, " ");
        print_clean(lines, list->entries[i].name.str, (size_t)list->entries[i].name.length);
    }
    text_print(lines, "\n");
}

static void describe_texts(exr_context_t file, int part, Text *lines) {
    int32_t count = 0;
    if (exr_get_attribute_count(file, part, &count)) return;
    for (int32_t i = 0; i < count; i++) {
        const exr_attribute_t *attribute = NULL;
        if (exr_get_attribute_by_index(file, part, EXR_ATTR_LIST_FILE_ORDER, i, &attribute) ||
            attribute->type != EXR_ATTR_STRING)
            continue;
        print_clean(lines, attribute->name, strlen(attribute->name));
        text_print(lines, ": ");
        print_clean(lines, attribute->string->str, (size_t)attribute->string->length);
        text_print(lines, "\n");
    }
}

bool exr_describe(const Text *bytes, Text *lines) {
    exr_context_t file = NULL;
    ExrStream stream = {.in = bytes};
    int parts = 0;
    if (!begin(&file, &stream)) return false;
    if (exr_get_count(file, &parts) != EXR_ERR_SUCCESS) parts = 0;
    for (int part = 0; part < parts; part++) {
        describe_windows(file, part, lines);
        describe_channels(file, part, lines);
        describe_texts(file, part, lines);
    }
    exr_finish(&file);
    return parts > 0;
}

bool exr_attributes(const Text *bytes, AttributeList *list) {
    exr_context_t file = NULL;
    ExrStream stream = {.in = bytes};
    int32_t count = 0;
    if (!begin(&file, &stream)) return false;
    if (exr_get_attribute_count(file, 0, &count) != EXR_ERR_SUCCESS) count = 0;
    for (int32_t i = 0; i < count; i++) {
        const exr_attribute_t *attribute = NULL;
        if (exr_get_attribute_by_index(file, 0, EXR_ATTR_LIST_FILE_ORDER, i, &attribute) == EXR_ERR_SUCCESS &&
            attribute->type == EXR_ATTR_STRING)
            attribute_add(list, attribute->name, "%.*s", (int)attribute->string->length,
                          attribute->string->str);
    }
    exr_finish(&file);
    return true;
}
