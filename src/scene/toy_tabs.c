#include "scene/toy_tabs.h"

#include <string.h>
#include <unistd.h>

static const char image[] = "image.glsl", common[] = "common.glsl", buffer[] = "buffer-a.glsl";

/* The path of a file beside another one, to be freed; NULL where there is none. */
static char *beside(const char *path, const char *name) {
    const char *slash = strrchr(path, '/');
    Text found = {0};
    text_print(&found, "%.*s%s", slash ? (int)(slash + 1 - path) : 0, path, name);
    if (access(text_string(&found), F_OK) == 0) return found.data;
    text_free(&found);
    return NULL;
}

static bool is_named(const char *path, const char *name) {
    const char *slash = strrchr(path, '/');
    return strcmp(slash ? slash + 1 : path, name) == 0;
}

void toy_tabs_find(SceneFile *file) {
    bool shows = is_named(file->path, image);
    if (!file->facts.is_toy || (!shows && !is_named(file->path, buffer))) return;
    file->common = beside(file->path, common);
    if (shows) file->buffer = beside(file->path, buffer);
}

char *toy_tabs_image(const char *folder) {
    Text within = {0};
    text_print(&within, "%s%s", folder, folder[0] && folder[strlen(folder) - 1] == '/' ? "" : "/");
    char *path = beside(text_string(&within), image);
    text_free(&within);
    return path;
}
