/* One GLSL text from many files: `#include` resolved, every line traceable to the file it came from.
 *
 *   #include "shape/sphere.glsl"   a file beside the including one, else in the GLSL library; each file once
 *   #include <sky>                 a slot: the file that the host chose for that name
 *   #include <scene>               the same, but always the user's own file, never one of the library's
 *   #include <materials>           written here: material_sample(), _pdf() and _value(), a call for each
 * material/ file included so far, material_throws(), and material_emitted() where one of them emits
 *
 * A file in a folder named material/ gets a number when it is included, MATERIAL_MATTE for
 * material/matte.glsl. So a new method or material is a new file, and what is not included is not compiled.
 */
#pragma once

#include "base/error.h"
#include "base/text.h"

typedef struct GlslSlot {
    const char *name; /* "sky" */
    const char
        *path; /* relative to the library, or to the working folder if it starts with '/' or exists there */
    const char *text; /* instead of a path: GLSL that the host wrote */
} GlslSlot;

typedef struct GlslSource {
    Text text;
    char **files; /* by source-string number; the first is the entry file */
    int file_count;
    char **materials; /* names in order of inclusion: "matte" */
    int material_count;
} GlslSource;

/* Flattens `entry` (a path as in GlslSlot, the user's own where there are no slots). `slots` ends with a NULL
 * name. Fails with STATUS_SCENE and the place of the #include that is wrong. */
MUST_CHECK bool glsl_source_create(GlslSource *source, const char *library, const char *entry,
                                   const GlslSlot *slots, Error *error);
void glsl_source_destroy(GlslSource *source);

/* The text for the driver, to be freed: each #line made a comment. Mesa forgets which file a #line named, so
 * that lines are counted through the whole text and looked up in it. */
char *glsl_source_plain(const GlslSource *source);

/* Turns a driver's log on the plain text into an error: each "0:514(3): error: words" becomes
 * "scenes/a.glsl:14: words". */
void glsl_source_explain(const GlslSource *source, const char *log, Error *error);

/* Whether a line that starts inside a block comment (or not) ends inside one. */
bool glsl_ends_in_comment(const char *line, bool inside);

/* Whether the text defines a function of that name (outside comments). */
bool glsl_source_defines(const GlslSource *source, const char *function);

/* Whether a material of the text emits: the file material/NAME.glsl defines NAME_emitted(). */
bool glsl_source_emits(const GlslSource *source);

/* Whether a material of the text may throw light in narrow lobes or single directions: each may that does not
 * declare `const bool NAME_THROWS = false`. */
bool glsl_source_throws(const GlslSource *source);

/* How often the text calls a function of that name (outside comments). */
int glsl_source_calls(const GlslSource *source, const char *function);

/* Whether the file, by the end of its path, is among those that the text was made of. */
bool glsl_source_includes(const GlslSource *source, const char *file);

/* Whether the text has this identifier (outside comments), and whether it declares it, as "float iTime". */
bool glsl_source_mentions(const GlslSource *source, const char *name);
bool glsl_source_declares(const GlslSource *source, const char *type, const char *name);
