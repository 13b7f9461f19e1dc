#include "view/watch.h"

#include "base/clock.h"
#include "base/memory.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* A file whose stamp is equal has not changed. All numbers are 0 if there is no file. */
typedef struct Stamp {
    long long seconds, nanoseconds, size, node;
} Stamp;

struct WatchedFile {
    char *path, *folder;
    Stamp stamp, folder_stamp;
};

static const double interval_s = 0.1;

static Stamp stamp_of(const char *path) {
    struct stat status;
    if (stat(path, &status) != 0) return (Stamp){0};
    return (Stamp){status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size, (long long)status.st_ino};
}

/* Reads the stamp anew and returns whether it has changed. */
static bool refresh(Stamp *stamp, const char *path) {
    Stamp before = *stamp;
    *stamp = stamp_of(path);
    return memcmp(&before, stamp, sizeof before) != 0;
}

static char *folder_of(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? memory_string_part(path, (size_t)(slash - path) + 1) : memory_string(".");
}

void watch_add_file(Watch *watch, const char *path) {
    for (int i = 0; i < watch->count; i++) {
        if (strcmp(watch->files[i].path, path) == 0) return;
    }
    watch->files = memory_grow(watch->files, (size_t)watch->count + 1, sizeof *watch->files);
    watch->files[watch->count++] =
        (WatchedFile){.path = memory_string(path), .folder = folder_of(path), .stamp = stamp_of(path)};
}

static void add_folder(Watch *watch, const char *folder, int depth) {
    DIR *entries = opendir(folder);
    if (!entries) return;
    for (struct dirent *entry; (entry = readdir(entries));) {
        if (entry->d_name[0] == '.') continue;
        Text path = {0};
        text_print(&path, "%s/%s", folder, entry->d_name);
        const char *dot = strrchr(entry->d_name, '.');
        struct stat status;
        bool known = stat(text_string(&path), &status) == 0;
        if (known && S_ISDIR(status.st_mode) && depth < 4) add_folder(watch, text_string(&path), depth + 1);
        if (known && S_ISREG(status.st_mode) && dot && strcmp(dot, ".glsl") == 0)
            watch_add_file(watch, text_string(&path));
        text_free(&path);
    }
    closedir(entries);
}

void watch_add(Watch *watch, const SourceStore *sources) {
    add_folder(watch, sources->folder, 0);
    for (int i = 0; i < sources->file_count; i++) watch_add_file(watch, sources->files[i]->path);
}

void watch_folders(Watch *watch, bool on) {
    watch->folders = on;
    for (int i = 0; on && i < watch->count; i++)
        watch->files[i].folder_stamp = stamp_of(watch->files[i].folder);
}

void watch_free(Watch *watch) {
    for (int i = 0; i < watch->count; i++) {
        free(watch->files[i].path);
        free(watch->files[i].folder);
    }
    free(watch->files);
    *watch = (Watch){0};
}

bool watch_changed(Watch *watch) {
    bool changed = false;
    if (clock_seconds() < watch->looked + interval_s) return false;
    watch->looked = clock_seconds();
    for (int i = 0; i < watch->count; i++) {
        WatchedFile *file = &watch->files[i];
        changed |= refresh(&file->stamp, file->path);
        if (watch->folders) changed |= refresh(&file->folder_stamp, file->folder);
    }
    bool settled = watch->unsettled && !changed;
    watch->unsettled = changed;
    return settled;
}
