/* Which lines of a GLSL text count: not those that start inside a comment, and not those that `#if 0` leaves
 * out. Conditions other than a plain 0 are the compiler's business: their lines count. */
#pragma once

#include <stdbool.h>

/* A zeroed struct is before the text's first line. */
typedef struct GlslBlocks {
    bool in_comment;
    /* How many conditions are open from the `#if 0` on; 0 outside of such a block. */
    int left_out;
} GlslBlocks;

/* Steps over a line and tells whether it counts. `#else` and `#endif` of a block that is left out do not. */
bool glsl_line_counts(GlslBlocks *blocks, const char *line);

/* What follows `#WORD` in a line that is this directive, else NULL. */
const char *glsl_directive(const char *line, const char *word);
