/* Leaves out what a text does not use. */
#pragma once

#include "base/text.h"
#include "source/glsl_source.h"

/* Takes functions, constants, variables and structures of the library away that nothing reaches: neither the
 * user's files among the source's, nor directives, nor `roots`, a text of GLSL. `library` is the folder of
 * the library. Lines that are left keep their #line. */
void prune(GlslSource *source, const char *library, const char *roots);
