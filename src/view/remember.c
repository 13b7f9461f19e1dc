#include "view/remember.h"

#include "base/file.h"
#include "base/memory.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

char *remember_path(void) {
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    Text path = {0};
    /* The standard says that a path which is not absolute is to be ignored. */
    if (state && *state == '/')
        text_print(&path, "%s", state);
    else if (home && *home == '/')
        text_print(&path, "%s/.local/state", home);
    else
        return NULL;
    text_print(&path, "/magichour/window.ini");
    return path.data;
}

bool remember_exists(const char *path) {
    return access(path, F_OK) == 0;
}

void remember_write(const char *path, const char *text) {
    char *folder = memory_string(path);
    for (char *slash = strchr(folder + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = 0;
        mkdir(folder, 0700);
        *slash = '/';
    }
    free(folder);
    Error ignored;
    (void)!file_replace(path, text, strlen(text), &ignored);
}
