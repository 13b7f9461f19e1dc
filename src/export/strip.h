/* A flattened text for people to read: without #line and #version, and without most of the library's
 * comments. */
#pragma once

#include "base/text.h"
#include "source/glsl_source.h"

/* Which comments of the library stay: none; one of a line above a structure, a constant or a function; or
 * also longer ones there, and those of a structure's members. */
typedef enum StripComments { STRIP_ALL, STRIP_MOST, STRIP_FEW } StripComments;

/* Writes the text anew. `library` is the folder of the GLSL library.
 *
 * - The user's own files keep their comments, but for annotations (`//@`); and so does the entry file, but
 * for the first one.
 * - The library keeps the comments that are asked for; and all that begin with "//=", as "//".
 * - Each file begins with a line that names it. Of blank lines in a row one is left. */
Text strip(const GlslSource *source, const char *library, StripComments comments);
