#include "base/known.h"

#include <stdarg.h>
#include <stdio.h>

Known known_to(const char *word, size_t length) {
    return (Known){.near = near_to(word, length)};
}

void known_add(Known *known, const char *name) {
    near_try(&known->near, name);
    text_print(&known->names, "%s%s", known->names.size ? ", " : "", name);
}

bool known_fail(Known *known, Status status, Error *error, const char *format, ...) {
    char words[1024];
    va_list arguments;
    const char *near = known->near.name;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    error_set(error, status, "%s%s%s%s (known: %s)", words, near ? ": did you mean " : "", near ? near : "",
              near ? "?" : "", known->names.size ? text_string(&known->names) : "none");
    known_free(known);
    return false;
}

void known_free(Known *known) {
    text_free(&known->names);
}
