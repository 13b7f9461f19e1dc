#include "image/exr_attribute.h"

#include <openexr.h>
#include <string.h>

/* Without this, OpenEXR complains on standard error. */
static void complaint_ignore(exr_const_context_t context, exr_result_t code, const char *message) {
    (void)context;
    (void)code;
    (void)message;
}

bool exr_attribute(const char *path, const char *name, Text *value) {
    exr_context_t file = NULL;
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    const exr_attribute_t *attribute = NULL;
    settings.error_handler_fn = complaint_ignore;
    if (exr_start_read(&file, path, &settings) != EXR_ERR_SUCCESS) return false;
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
