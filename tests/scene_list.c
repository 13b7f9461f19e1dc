#include "scene_list.h"

#include "support.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_scene(const struct dirent *entry) {
    const char *end = strrchr(entry->d_name, '.');
    return end && strcmp(end, ".glsl") == 0;
}

SceneList scene_list(void) {
    SceneList list = {.count = 0};
    struct dirent **entries;
    int count = scandir("scenes", &entries, is_scene, alphasort);
    for (int i = 0; i < count; i++) {
        if (i < MOST_SCENES)
            snprintf(list.paths[list.count++], sizeof list.paths[0], "scenes/%s", entries[i]->d_name);
        free(entries[i]);
    }
    if (count >= 0) free(entries);
    if (count < 1 || count > MOST_SCENES) fail_msg("%d scenes", count);
    return list;
}
