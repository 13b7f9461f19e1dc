/* Errors about a name that is not known: they list those that are, and ask for the one that was meant.
 *
 *     Known known = known_to(name, strlen(name));
 *     for (int i = 0; rows[i].name; i++) known_add(&known, rows[i].name);
 *     return known_fail(&known, STATUS_USAGE, error, "unknown atmosphere '%s'", name);
 *
 * says "unknown atmosphere 'eart': did you mean earth? (known: simmons2017, earth)".
 */
#pragma once

#include "base/error.h"
#include "base/near.h"
#include "base/text.h"

typedef struct Known {
    Near near;
    /* The names so far, with commas between them. */
    Text names;
} Known;

/* No name is known yet. The word has `length` bytes and stays the caller's. */
Known known_to(const char *word, size_t length);

/* Adds a name, which stays the caller's and must outlive `known`. */
void known_add(Known *known, const char *name);

/* Sets the error, frees `known`, and returns false. */
bool known_fail(Known *known, Status status, Error *error, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* For a search that ended well. */
void known_free(Known *known);
