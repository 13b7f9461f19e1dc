#include "view/menu.h"

#include "base/text.h"

#include <stdlib.h>
#include <string.h>

/* The folder of a file, without links and dots; NULL if there is none. */
static char *folder_of(const char *path) {
    const char *slash = strrchr(path, '/');
    Text folder = {0};
    text_print(&folder, "%.*s", slash ? (int)(slash - path + 1) : 1, slash ? path : ".");
    char *resolved = realpath(text_string(&folder), NULL);
    text_free(&folder);
    return resolved;
}

void menu_update(SceneMenu *menu, ViewState *state, const char *library) {
    if (!state->wishes.list) return;
    state->wishes.list = false;
    menu_free(menu);
    char *beside = folder_of(state->file.file->path), *folder = scene_list_folder(library),
         *installed = realpath(folder, NULL);
    if (beside) menu->beside = scene_list_read(beside);
    if (installed && !(beside && strcmp(beside, installed) == 0))
        menu->installed = scene_list_read(installed);
    free(beside);
    free(folder);
    free(installed);
}

void menu_free(SceneMenu *menu) {
    scene_list_free(&menu->beside);
    scene_list_free(&menu->installed);
}
