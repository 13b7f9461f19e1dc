/* One GLSL text from many files: `#include` resolved, every line traceable to the file it came from.
 *
 *   #include "shape/sphere.glsl"   a file beside the including one, else in the GLSL library; each file once,
 *                                  by whatever spelling or link it is named
 *   #include <sky>                 a slot: the file that the host chose for that name
 *   #include <scene>               the same, but always the user's own file, never one of the library's; so
 * is <common> #include <materials>           written here (source/glsl_materials.h)
 *
 * A file of the user's that is found under the name of one of the library's takes its place everywhere: the
 * library's own files get it too. What is not included is not compiled, and an `#include` between `#if 0` and
 * its `#else` or `#endif` is none.
 *
 * #line belongs to the flattener: a file's own is left out.
 *
 * Which files may be read, and how large they may be, is the store's matter (source/source_store.h). */
#pragma once

#include "base/error.h"
#include "base/text.h"
#include "source/glsl_materials.h"
#include "source/source_store.h"

enum {
    /* How deep files may include each other, and how many #include lines a text may be made of. */
    GLSL_DEPTH_MOST = 64,
    GLSL_INCLUDES_MOST = 10000
};

typedef struct GlslSlot {
    /* "sky" */
    const char *name;
    /* Relative to the library, or to the working folder if it starts with '/' or exists there. */
    const char *path;
    /* Instead of a path: GLSL that the host wrote. */
    const char *text;
} GlslSlot;

typedef struct GlslSource {
    Text text;
    /* By source-string number; the first is the entry file. */
    char **files;
    int file_count;
    GlslMaterials materials;
} GlslSource;

/* Flattens `entry` (a path as in GlslSlot, the user's own where there are no slots). `slots` ends with a NULL
 * name. Fails with STATUS_SCENE and the place of the #include that is wrong. */
MUST_CHECK bool glsl_source_create(GlslSource *source, SourceStore *store, const char *entry,
                                   const GlslSlot *slots, Error *error);
void glsl_source_destroy(GlslSource *source);

/* The path of the file of that number, "" where there is none. */
const char *glsl_source_file(const GlslSource *source, int file);

/* Whether the file, by the end of its path, is among those that the text was made of. */
bool glsl_source_includes(const GlslSource *source, const char *file);

/* Whether the file of that number is the user's, and not in the folder of the GLSL library. */
bool glsl_source_is_own(const GlslSource *source, int file, const char *library);
