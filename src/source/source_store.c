#include "source/source_store.h"

#include "base/lines.h"
#include "base/memory.h"
#include "base/regular.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

SourceStore *source_store_create(const char *folder) {
    SourceStore *store = memory_get(1, sizeof *store);
    *store = (SourceStore){.folder = memory_string(folder), .users = 1};
    source_folders_add(&store->folders, folder);
    return store;
}

SourceStore *source_store_share(SourceStore *store) {
    store->users++;
    return store;
}

static void free_file(SourceFile *file) {
    text_free(&file->text);
    free(file->path);
    free(file);
}

void source_store_release(SourceStore *store) {
    if (!store || --store->users > 0) return;
    for (int i = 0; i < store->file_count; i++) free_file(store->files[i]);
    for (int i = 0; i < store->shadow_count; i++) {
        free(store->shadows[i].name);
        free(store->shadows[i].path);
    }
    for (int i = 0; i < store->chosen_count; i++) free(store->chosen[i]);
    source_folders_free(&store->folders);
    free(store->chosen);
    free(store->files);
    free(store->shadows);
    free(store->folder);
    free(store);
}

static bool is_chosen(const SourceStore *store, const char *path) {
    for (int i = 0; i < store->chosen_count; i++) {
        if (strcmp(store->chosen[i], path) == 0) return true;
    }
    return false;
}

void source_store_choose(SourceStore *store, const char *path) {
    if (is_chosen(store, path)) return;
    const char *slash = strrchr(path, '/');
    char *folder = slash ? memory_string_part(path, (size_t)(slash - path) + 1) : memory_string(".");
    source_folders_add(&store->folders, folder);
    free(folder);
    store->chosen = memory_grow(store->chosen, (size_t)store->chosen_count + 1, sizeof *store->chosen);
    store->chosen[store->chosen_count++] = memory_string(path);
}

/* A file that an editor has replaced since is another one on the disk, but not here. */
static const SourceFile *find_path(const SourceStore *store, const char *path) {
    for (int i = 0; i < store->file_count; i++) {
        if (strcmp(store->files[i]->path, path) == 0) return store->files[i];
    }
    return NULL;
}

static const SourceFile *find_node(const SourceStore *store, const struct stat *found) {
    for (int i = 0; i < store->file_count; i++) {
        const SourceFile *file = store->files[i];
        if (file->device == found->st_dev && file->node == found->st_ino) return file;
    }
    return NULL;
}

/* Whether one more file may be read. */
static bool check_bounds(const SourceStore *store, const SourceFile *file, Error *error) {
    if (store->file_count >= SOURCE_FILES_MOST)
        return error_set(error, STATUS_SCENE, "%s: more than %d files for one scene", file->path,
                         SOURCE_FILES_MOST);
    size_t size = store->size + file->text.size;
    return size <= SOURCE_TEXTS_MOST || error_set(error, STATUS_SCENE,
                                                  "%s: with this file the scene's texts have %zu bytes, and "
                                                  "at most %d can be read",
                                                  file->path, size, SOURCE_TEXTS_MOST);
}

/* Reads what is open. */
static bool take_file(SourceStore *store, int descriptor, size_t most, SourceFile *file, Error *error) {
    if (!is_chosen(store, file->path) && !source_folders_have(&store->folders, descriptor, file->path))
        return error_set(error, STATUS_SCENE,
                         "%s is not read: it lies outside of the scene's folder and of the GLSL library "
                         "(--allow-includes DIR allows the files of another folder)",
                         file->path);
    FileBounds bounds = {.status = STATUS_SCENE, .most = most};
    if (!lines_read_open(descriptor, file->path, &bounds, &file->text, error)) return false;
    if (most == SOURCE_TABLE_MOST) return true;
    if (!check_bounds(store, file, error)) return false;
    store->size += file->text.size;
    return true;
}

static const SourceFile *open_file(SourceStore *store, const char *path, size_t most, Error *error) {
    struct stat found;
    int descriptor = regular_open(path, &found, STATUS_SCENE, error);
    if (descriptor < 0) return NULL;
    const SourceFile *known = find_node(store, &found);
    SourceFile *next = NULL;
    if (!known) {
        next = memory_get(1, sizeof *next);
        *next = (SourceFile){.path = memory_string(path), .device = found.st_dev, .node = found.st_ino};
        if (!take_file(store, descriptor, most, next, error)) free_file(next), next = NULL;
    }
    close(descriptor);
    if (!next) return known;
    store->files = memory_grow(store->files, (size_t)store->file_count + 1, sizeof(SourceFile *));
    store->files[store->file_count++] = next;
    return next;
}

static bool read_within(SourceStore *store, const char *path, size_t most, const SourceFile **file,
                        Error *error) {
    *file = find_path(store, path);
    if (!*file) *file = open_file(store, path, most, error);
    if (!*file || (*file)->text.size <= most) return *file != NULL;
    return error_set(error, STATUS_SCENE, "%s: cannot be read: it has %zu bytes, and at most %zu can be",
                     path, (*file)->text.size, most); /* a table that is included */
}

bool source_store_read(SourceStore *store, const char *path, const SourceFile **file, Error *error) {
    return read_within(store, path, SOURCE_FILE_MOST, file, error);
}

bool source_store_read_table(SourceStore *store, const char *path, const SourceFile **file, Error *error) {
    return read_within(store, path, SOURCE_TABLE_MOST, file, error);
}

const char *source_store_shadowed(const SourceStore *store, const char *name) {
    for (int i = 0; i < store->shadow_count; i++) {
        if (strcmp(store->shadows[i].name, name) == 0) return store->shadows[i].path;
    }
    return NULL;
}

const char *source_store_shadow(SourceStore *store, const char *name, const char *path) {
    const char *first = source_store_shadowed(store, name);
    if (first) return first;
    store->shadows = memory_grow(store->shadows, (size_t)store->shadow_count + 1, sizeof *store->shadows);
    store->shadows[store->shadow_count] = (SourceShadow){memory_string(name), memory_string(path)};
    return store->shadows[store->shadow_count++].path;
}
