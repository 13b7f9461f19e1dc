/* Which file an #include means. */
#pragma once

#include "source/source_store.h"

#include <stdbool.h>

typedef struct Found {
    /* NULL where there is no such file; to be freed. */
    char *path;
    /* Whether it is the user's, and not the library's. */
    bool own;
} Found;

/* For a path that the host chose: relative to the library, or else to the working folder; `own` paths are
 * never looked for in the library. */
Found glsl_find_chosen(SourceStore *store, const char *path, bool own);

/* For the name that stands in quotes in the file `includer`: beside that file, else in the library. An
 * absolute path is itself. Where the user has a file of a library file's name, the first one that was found
 * takes its place. */
Found glsl_find_quoted(SourceStore *store, const Found *includer, const char *name);
