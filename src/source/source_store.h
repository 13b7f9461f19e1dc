/* The texts of one reading of a scene: each file is opened once, however many programs are made of it, so
 * that all of them are made of the same words. Who wants to see later edits makes a new store. */
#pragma once

#include "base/text.h"

#include <sys/types.h>

typedef struct SourceFile {
    /* The path by which it was opened first; the same file by another spelling or a link is this one. */
    char *path;
    /* Without a byte order mark. */
    Text text;
    dev_t device;
    ino_t node;
} SourceFile;

/* A file of the user's that stands in for the library's file of the same name. */
typedef struct SourceShadow {
    char *name, *path;
} SourceShadow;

typedef struct SourceStore {
    /* Of the GLSL library. */
    char *folder;
    SourceFile **files;
    int file_count;
    SourceShadow *shadows;
    int shadow_count;
    /* References. */
    int users;
} SourceStore;

/* With the GLSL library in this folder. Nothing is opened yet. To be released. */
SourceStore *source_store_create(const char *folder);

/* One more reference, to be released. */
SourceStore *source_store_share(SourceStore *store);

/* The last one frees the store. NULL is allowed. */
void source_store_release(SourceStore *store);

/* The file, which the store owns and opens where this is the first time that it is asked for. STATUS_SCENE
 * for what cannot be read or is no text. */
MUST_CHECK bool source_store_read(SourceStore *store, const char *path, const SourceFile **file,
                                  Error *error);

/* Notes that the user's file at `path` stands in for the library's `name`, such as "material/mirror.glsl",
 * unless another does already. Returns the path of the one that does. */
const char *source_store_shadow(SourceStore *store, const char *name, const char *path);

/* The path of the user's file that stands in for the library's `name`, or NULL. */
const char *source_store_shadowed(const SourceStore *store, const char *name);
