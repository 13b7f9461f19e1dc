#include "scene/value.h"

#include "base/text.h"

#include <stdio.h>
#include <string.h>

bool value_parse(const char *name, const char *text, int count, double min, double max, double *values,
                 Error *error) {
    double parsed[3];
    int found = 0;
    for (const char *at = text;; at++) {
        char number[64];
        size_t length = strcspn(at, ",");
        if (found >= count || length >= sizeof number) {
            return error_set(error, STATUS_USAGE, "%s: '%s' is not %s", name, text,
                             count == 3 ? "three numbers a,b,c" : "one number");
        }
        snprintf(number, sizeof number, "%.*s", (int)length, at);
        if (!number_parse_range(name, number, min, max, &parsed[found++], error)) return false;
        at += length;
        if (!*at) break;
    }
    if (found != 1 && found != count) {
        return error_set(error, STATUS_USAGE, "%s: '%s' is not three numbers a,b,c", name, text);
    }
    for (int i = 0; i < count; i++) values[i] = parsed[found == 1 ? 0 : i];
    return true;
}
