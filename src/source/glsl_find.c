#include "source/glsl_find.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* folder/name, or NULL if there is no such file; to be freed. */
static char *existing_file(const char *folder, size_t folder_length, const char *name) {
    Text path = {0};
    if (folder_length) text_print(&path, "%.*s/", (int)folder_length, folder);
    text_print(&path, "%s", name);
    if (access(text_string(&path), F_OK) == 0) return path.data;
    text_free(&path);
    return NULL;
}

static char *in_library(const SourceStore *store, const char *name) {
    return existing_file(store->folder, strlen(store->folder), name);
}

static bool same_file(const char *a, const char *b) {
    struct stat first, second;
    return stat(a, &first) == 0 && stat(b, &second) == 0 && first.st_dev == second.st_dev &&
           first.st_ino == second.st_ino;
}

/* "material/matte.glsl" for "./material//../material/matte.glsl", to be freed. */
static char *plain_name(const char *name) {
    char *plain = memory_string(name);
    size_t used = 0;
    for (const char *at = name; *at;) {
        size_t length = strcspn(at, "/");
        bool stays = length == 0 || (length == 1 && *at == '.');
        bool climbs = length == 2 && strncmp(at, "..", 2) == 0 && used && plain[used - 1] != '.';
        if (climbs) {
            while (used && plain[used - 1] != '/') used--;
            used -= used > 0;
        } else if (!stays) {
            if (used) plain[used++] = '/';
            memmove(plain + used, at, length);
            used += length;
        }
        at += length + (at[length] == '/');
    }
    plain[used] = 0;
    return plain;
}

Found glsl_find_chosen(SourceStore *store, const char *path, bool own) {
    char *found = own ? NULL : in_library(store, path);
    if (found) return (Found){found, false};
    source_store_choose(store, path);
    return (Found){existing_file("", 0, path), true};
}

/* The user's file that was found beside another of the user's: it may be one that the library has too. */
static Found found_beside(SourceStore *store, char *beside, const char *name) {
    char *library = in_library(store, name);
    bool other = library && !same_file(beside, library);
    Found found = {beside, !library || other};
    if (other) {
        found.path = memory_string(source_store_shadow(store, name, beside));
        free(beside);
    }
    free(library);
    return found;
}

Found glsl_find_quoted(SourceStore *store, const Found *includer, const char *name) {
    if (*name == '/') return (Found){existing_file("", 0, name), true};
    const char *slash = strrchr(includer->path, '/');
    size_t length = slash > includer->path ? (size_t)(slash - includer->path) : slash != NULL;
    char *beside = existing_file(includer->path, length, name), *plain = plain_name(name);
    Found found;
    if (beside && includer->own) {
        found = found_beside(store, beside, plain);
    } else {
        /* A file beside one of the library's is the library's, and known by its path in there. */
        size_t folder = strlen(store->folder);
        bool inside = beside && strncmp(beside, store->folder, folder) == 0 && beside[folder] == '/';
        char *logical = plain_name(inside ? beside + folder + 1 : name);
        const char *shadow = source_store_shadowed(store, logical);
        found = shadow   ? (Found){memory_string(shadow), true}
                : beside ? (Found){memory_string(beside), false}
                         : (Found){in_library(store, name), false};
        free(logical);
        free(beside);
    }
    free(plain);
    return found;
}
