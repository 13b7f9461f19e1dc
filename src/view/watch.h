/* Which files a picture was made from, and whether one of them has changed: by looking at them, which works
 * on every file system and however an editor saves. */
#pragma once

#include "scene/glsl_source.h"

typedef struct WatchedFile WatchedFile;

typedef struct Watch {
    WatchedFile *files; /* owned */
    int count;
    double looked;  /* when */
    bool unsettled; /* something changed at the last look */
    bool folders;   /* what comes and goes beside the files counts too */
} Watch;

/* Watches these files and every .glsl file below the library's folder, from now on and beside those it has.
 */
void watch_add(Watch *watch, const char *library, const GlslSource *source);
void watch_add_file(Watch *watch, const char *path);

/* Whether a change of the files' folders counts too: a scene that names a missing file is mended by one that
 * could not be watched before. */
void watch_folders(Watch *watch, bool on);
void watch_free(Watch *watch);

/* Whether a file has changed since the last yes, and then stayed as it is for a moment: nobody is still
 * writing it. Looks about ten times a second, however often it is asked. */
bool watch_changed(Watch *watch);
