#include "scene/scene_list.h"

#include "base/memory.h"
#include "scene/annotation.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

static const char ending[] = ".glsl";

char *scene_list_folder(const char *library) {
    /* The library may be named by a link, or as "." or "glsl/". */
    char *resolved = realpath(library, NULL);
    const char *place = resolved ? resolved : library, *slash = strrchr(place, '/');
    Text folder = {0};
    text_append(&folder, place, slash ? (size_t)(slash - place) + 1 : 0);
    text_print(&folder, "scenes");
    free(resolved);
    return folder.data;
}

static int is_named_as_scene(const struct dirent *entry) {
    size_t length = strlen(entry->d_name), least = sizeof ending - 1;
    return entry->d_name[0] != '.' && length > least && strcmp(entry->d_name + length - least, ending) == 0;
}

/* Whether the text may be drawn by itself: what only others include defines none of these. */
static bool is_scene(const char *text) {
    return strstr(text, "scene_intersect") || strstr(text, "mainImage");
}

static void add_file(SceneList *list, const char *folder, const char *name) {
    Text path = {0};
    text_print(&path, "%s/%s", folder, name);
    SceneFile *file = scene_file_create(text_string(&path), "");
    Error ignored;
    /* The title is known even if a later annotation is wrong. A file that cannot be read has no text. */
    (void)!annotation_read(file, &ignored);
    if (file->sources->file_count && is_scene(text_string(&file->sources->files[0]->text))) {
        list->entries = memory_grow(list->entries, (size_t)list->count + 1, sizeof *list->entries);
        list->entries[list->count++] =
            (SceneEntry){.name = memory_string_part(name, strlen(name) - (sizeof ending - 1)),
                         .title = memory_string(file->title),
                         .path = memory_string(file->path)};
    }
    scene_file_release(file);
    text_free(&path);
}

SceneList scene_list_read(const char *folder) {
    SceneList list = {0};
    struct dirent **entries = NULL;
    int count = scandir(folder, &entries, is_named_as_scene, alphasort);
    for (int i = 0; i < count; i++) {
        add_file(&list, folder, entries[i]->d_name);
        free(entries[i]);
    }
    free(entries);
    return list;
}

void scene_list_free(SceneList *list) {
    for (int i = 0; i < list->count; i++) {
        free(list->entries[i].name);
        free(list->entries[i].title);
        free(list->entries[i].path);
    }
    free(list->entries);
    *list = (SceneList){0};
}
