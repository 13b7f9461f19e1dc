#include "scene/value.h"

#include "base/number.h"

#include <stdio.h>
#include <string.h>

static bool wrong_count(const char *name, const char *text, int count, Error *error) {
    const char *expected = count == 4   ? "four numbers a,b,c,d"
                           : count == 3 ? "three numbers a,b,c"
                                        : "one number";
    return error_set(error, STATUS_USAGE, "%s: '%s' is not %s", name, text, expected);
}

bool value_parse(const char *name, const char *text, int count, double min, double max, double *values,
                 Error *error) {
    double parsed[4];
    int found = 0;
    for (const char *at = text;; at++) {
        char number[64];
        size_t length = strcspn(at, ",");
        if (found >= count || length >= sizeof number) return wrong_count(name, text, count, error);
        snprintf(number, sizeof number, "%.*s", (int)length, at);
        if (!number_parse_range(name, number, min, max, &parsed[found++], error)) return false;
        at += length;
        if (!*at) break;
    }
    bool repeated = found == 1 && count == 3;
    if (found != count && !repeated) return wrong_count(name, text, count, error);
    for (int i = 0; i < count; i++) values[i] = parsed[repeated ? 0 : i];
    return true;
}
