#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool error_set(Error *error, Status status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    error->status = status;
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    return false;
}

bool error_prefix(Error *error, const char *format, ...) {
    char prefixed[sizeof error->text];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(prefixed, sizeof prefixed, format, arguments);
    va_end(arguments);
    if (length >= 0 && (size_t)length < sizeof prefixed) {
        snprintf(prefixed + length, sizeof prefixed - (size_t)length, "%.*s",
                 (int)(sizeof prefixed - (size_t)length - 1), error->text);
    }
    memcpy(error->text, prefixed, sizeof prefixed);
    return false;
}
