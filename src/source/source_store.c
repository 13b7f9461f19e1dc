#include "source/source_store.h"

#include "base/lines.h"
#include "base/memory.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

SourceStore *source_store_create(const char *folder) {
    SourceStore *store = memory_get(1, sizeof *store);
    *store = (SourceStore){.folder = strdup(folder), .users = 1};
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
    free(store->files);
    free(store->shadows);
    free(store->folder);
    free(store);
}

/* By the path first: a file that an editor has replaced since is another one on the disk, but not here. */
static const SourceFile *find(const SourceStore *store, const char *path, const struct stat *status) {
    for (int i = 0; i < store->file_count; i++) {
        if (strcmp(store->files[i]->path, path) == 0) return store->files[i];
    }
    for (int i = 0; status && i < store->file_count; i++) {
        const SourceFile *file = store->files[i];
        if (file->device == status->st_dev && file->node == status->st_ino) return file;
    }
    return NULL;
}

bool source_store_read(SourceStore *store, const char *path, const SourceFile **file, Error *error) {
    struct stat status = {0};
    bool there = stat(path, &status) == 0;
    *file = find(store, path, there ? &status : NULL);
    if (*file) return true;
    SourceFile *next = memory_get(1, sizeof *next);
    *next = (SourceFile){.path = strdup(path), .device = status.st_dev, .node = status.st_ino};
    if (!lines_read(path, STATUS_SCENE, &next->text, error)) {
        free_file(next);
        return false;
    }
    store->files = memory_grow(store->files, (size_t)store->file_count + 1, sizeof(SourceFile *));
    store->files[store->file_count++] = next;
    *file = next;
    return true;
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
    store->shadows[store->shadow_count] = (SourceShadow){strdup(name), strdup(path)};
    return store->shadows[store->shadow_count++].path;
}
