/* Sets variables to 0 that a GLSL text does not set, as WebGL does: variables of functions and of the text,
 * also in loops' heads and in macros, parameters that are `out`, arrays, and structures. No line is added. */
#pragma once

#include "source/glsl_source.h"

/* Changes the user's files among the source's; `library` is the folder of the others. Arrays outside of
 * functions are set at the start of `function`, which takes nothing. What this cannot express stays as it is:
 * structures that are declared within a function, and a macro's declarations that end outside of the
 * macro. */
void glsl_zero(GlslSource *source, const char *library, const char *function);
