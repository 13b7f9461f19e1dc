/* The folders whose files a scene may read. Scenes come from strangers: a name that one of them includes must
 * not lead to a file that is none of its business. */
#pragma once

#include "base/error.h"

/* A zeroed list is empty. */
typedef struct SourceFolders {
    /* Without links and dots; owned. */
    char **folders;
    int count;
} SourceFolders;

/* Adds a folder, with all below it; nothing where there is no such folder. */
void source_folders_add(SourceFolders *list, const char *folder);
void source_folders_free(SourceFolders *list);

/* Whether the open file is in one of the folders, or in one that was allowed. This is asked of the file
 * itself, whatever names and links led to it; `path` was its name. */
bool source_folders_have(const SourceFolders *list, int descriptor, const char *path);

/* Allows every scene of this process to read the files of a folder. Fails with STATUS_USAGE where there is no
 * such folder. */
MUST_CHECK bool source_folders_allow(const char *folder, Error *error);

/* Checks a name that stands in a scene: an absolute one has to lie in a folder that was allowed. Fails with
 * STATUS_SCENE, without a place. */
MUST_CHECK bool source_folders_check_name(const char *name, Error *error);
