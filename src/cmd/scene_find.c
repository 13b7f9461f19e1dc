#include "cmd/scene_find.h"

#include "base/memory.h"
#include "base/near.h"
#include "base/text.h"
#include "scene/scene_list.h"
#include "scene/toy_tabs.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char ending[] = ".glsl";

/* How many bytes of the word stand before ".glsl", or before its end. */
static size_t stem_length(const char *word) {
    size_t length = strlen(word), last = sizeof ending - 1;
    return length > last && strcmp(word + length - last, ending) == 0 ? length - last : length;
}

/* Whether a word may be an installed scene's name. All others are paths. */
static bool is_name(const char *word) {
    return word[0] && word[0] != '.' && !strchr(word, '/') && stem_length(word) == strlen(word);
}

/* The path of an installed scene, or NULL. */
static char *find_installed(const char *word, const char *folder) {
    Text path = {0};
    text_print(&path, "%s/%s%s", folder, word, ending);
    if (is_name(word) && access(text_string(&path), R_OK) == 0) return path.data;
    text_free(&path);
    return NULL;
}

static bool not_found(const char *word, const char *folder, Error *error) {
    const char *slash = strrchr(word, '/'), *stem = slash ? slash + 1 : word;
    SceneList list = scene_list_read(folder);
    Near near = near_to(stem, stem_length(stem));
    for (int i = 0; i < list.count; i++) near_try(&near, list.entries[i].name);
    Text more = {0};
    if (is_name(word)) text_print(&more, ", and %s has no scene of this name", folder);
    if (near.name)
        text_print(&more, ": did you mean %s%s?", is_name(word) ? "" : "the installed scene ", near.name);
    else if (is_name(word))
        text_print(&more, " (`magichour info` lists the scenes)");
    error_set(error, STATUS_SCENE, "%s: cannot be read: %s%s", word, strerror(ENOENT), text_string(&more));
    text_free(&more);
    scene_list_free(&list);
    return false;
}

bool scene_find(const char *word, const char *library, char **path, Error *error) {
    struct stat status;
    bool there = stat(word, &status) == 0, missing = !there && errno == ENOENT;
    char *folder = scene_list_folder(library);
    *path = there && S_ISDIR(status.st_mode) ? toy_tabs_image(word) : NULL;
    if (!*path) *path = there && !S_ISDIR(status.st_mode) ? NULL : find_installed(word, folder);
    bool ok = *path || !missing || not_found(word, folder, error);
    /* What else is wrong with the file is said when it is opened. */
    if (ok && !*path) *path = memory_string(word);
    free(folder);
    return ok;
}
