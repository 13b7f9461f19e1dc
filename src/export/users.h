/* Whose a part of a flattened text is. */
#pragma once

#include "source/glsl_source.h"

/* Whether the file of that number is the user's: neither the library's, nor written by the host. `library` is
 * the folder of the library. */
bool export_is_users(const GlslSource *source, int file, const char *library);
