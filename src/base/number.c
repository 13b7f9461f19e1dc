#include "base/number.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    if (!number_parse(text, &parsed))
        return error_set(error, STATUS_USAGE, "%s: '%s' is not a number, and one from %g to %g is needed",
                         name, text, min, max);
    if (parsed < min || parsed > max)
        return error_set(error, STATUS_USAGE, "%s: %s is outside the range from %g to %g", name, text, min,
                         max);
    *value = parsed;
    return true;
}
