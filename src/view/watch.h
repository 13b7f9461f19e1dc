/* Watches the files that a picture was made from, and says when one of them has changed. It looks at the
 * files again and again. This works on every file system, and however an editor saves. */
#pragma once

#include "source/source_store.h"

typedef struct WatchedFile WatchedFile;

typedef struct Watch {
    /* Owned. */
    WatchedFile *files;
    int count;
    /* The time of the last look. */
    double looked;
    /* Something had changed at the last look. */
    bool unsettled;
    /* Files that appear or disappear in the same folders count too. */
    bool folders;
} Watch;

/* Adds the store's files, and every .glsl file below its library's folder. */
void watch_add(Watch *watch, const SourceStore *sources);
void watch_add_file(Watch *watch, const char *path);

/* Turns on or off whether changes in the files' folders count too. They are needed if a scene includes a
 * missing file: creating the file repairs the scene, and a missing file cannot be watched. */
void watch_folders(Watch *watch, bool on);
void watch_free(Watch *watch);

/* Says whether a file has changed since this function last returned true. A change counts only after the file
 * has stayed the same for a moment, because an editor may still be writing it. It looks about ten times a
 * second, however often it is called. */
bool watch_changed(Watch *watch);
