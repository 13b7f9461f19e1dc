/* Names that a text lacks and a file of the library has: whoever writes a first scene forgets an #include. */
#pragma once

#include "source/glsl_source.h"

/* Adds to each line of a driver's error that quotes such a name which file to include. `folder` is that of
 * the library. */
void glsl_missing_advise(const GlslSource *source, const char *folder, Error *error);
