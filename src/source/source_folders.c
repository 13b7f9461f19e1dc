#include "source/source_folders.h"

#include "base/memory.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* What source_folders_allow() was told. */
static SourceFolders allowed;

void source_folders_add(SourceFolders *list, const char *folder) {
    char *real = realpath(folder, NULL);
    for (int i = 0; real && i < list->count; i++) {
        if (strcmp(list->folders[i], real) != 0) continue;
        free(real);
        return;
    }
    if (!real) return;
    list->folders = memory_grow(list->folders, (size_t)list->count + 1, sizeof *list->folders);
    list->folders[list->count++] = real;
}

void source_folders_free(SourceFolders *list) {
    for (int i = 0; i < list->count; i++) free(list->folders[i]);
    free(list->folders);
    *list = (SourceFolders){0};
}

static bool has(const SourceFolders *list, const char *real) {
    for (int i = 0; i < list->count; i++) {
        const char *folder = list->folders[i];
        size_t length = strlen(folder);
        /* Only the root's name ends in a slash. */
        if (strncmp(folder, real, length) == 0 && (folder[length - 1] == '/' || real[length] == '/'))
            return true;
    }
    return false;
}

/* The path of an open file without links and dots, to be freed; NULL where it is not known. */
static char *path_of(int descriptor, const char *path) {
    char name[64], real[PATH_MAX];
    snprintf(name, sizeof name, "/proc/self/fd/%d", descriptor);
    ssize_t length = readlink(name, real, sizeof real);
    if (length > 0 && length < (ssize_t)sizeof real && *real == '/')
        return memory_string_part(real, (size_t)length);
    /* Where there is no /proc: what the name leads to now, if that is the same file. */
    struct stat open_file, named;
    char *now = realpath(path, NULL);
    if (now && fstat(descriptor, &open_file) == 0 && stat(now, &named) == 0 &&
        open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino)
        return now;
    free(now);
    return NULL;
}

bool source_folders_have(const SourceFolders *list, int descriptor, const char *path) {
    char *real = path_of(descriptor, path);
    bool inside = real && (has(list, real) || has(&allowed, real));
    free(real);
    return inside;
}

bool source_folders_allow(const char *folder, Error *error) {
    struct stat status;
    int failed = stat(folder, &status) != 0 ? errno : S_ISDIR(status.st_mode) ? 0 : ENOTDIR;
    if (failed) return error_set(error, STATUS_USAGE, "%s: %s", folder, strerror(failed));
    source_folders_add(&allowed, folder);
    return true;
}

bool source_folders_check_name(const char *name, Error *error) {
    if (*name != '/') return true;
    char *real = realpath(name, NULL);
    bool inside = real && has(&allowed, real);
    free(real);
    return inside || error_set(error, STATUS_SCENE,
                               "'%s' is an absolute path: a scene names its files relative to itself "
                               "(--allow-includes DIR allows the files of another folder)",
                               name);
}
