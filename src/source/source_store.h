/* The texts of one reading of a scene: each file is opened once, however many programs are made of it, so
 * that all of them are made of the same words. Who wants to see later edits makes a new store. */
#pragma once

#include "base/text.h"
#include "source/source_folders.h"

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

/* What is read for one scene. */
enum {
    /* The bytes of a GLSL file, and of all of them with the library's. */
    SOURCE_FILE_MOST = 1 << 20,
    SOURCE_TEXTS_MOST = 4 << 20,
    SOURCE_FILES_MOST = 2000,
    /* The bytes of a table, such as one of spheres. */
    SOURCE_TABLE_MOST = 64 << 20
};

typedef struct SourceStore {
    /* Of the GLSL library. */
    char *folder;
    /* The library, and the folders of the files that the host chose. */
    SourceFolders folders;
    /* The paths of the files that the host chose, which may lie anywhere. */
    char **chosen;
    int chosen_count;
    /* The bytes of all texts but tables. */
    size_t size;
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

/* Says that the host chose the file of this path, and not a scene. It may lie anywhere, and the files of its
 * folder may be read, with all below. */
void source_store_choose(SourceStore *store, const char *path);

/* The file, which the store owns and opens where this is the first time that it is asked for. STATUS_SCENE
 * for what is no regular file, cannot be read, is too large, or is no text, and for files that lie outside of
 * the library and of the folders of what the host chose. */
MUST_CHECK bool source_store_read(SourceStore *store, const char *path, const SourceFile **file,
                                  Error *error);

/* The same for a file that is no GLSL and may be larger. */
MUST_CHECK bool source_store_read_table(SourceStore *store, const char *path, const SourceFile **file,
                                        Error *error);

/* Notes that the user's file at `path` stands in for the library's `name`, such as "material/mirror.glsl",
 * unless another does already. Returns the path of the one that does. */
const char *source_store_shadow(SourceStore *store, const char *name, const char *path);

/* The path of the user's file that stands in for the library's `name`, or NULL. */
const char *source_store_shadowed(const SourceStore *store, const char *name);
