/* Lists the GLSL library's files, and which of them a shader includes. */
#pragma once

#include "base/text.h"

/* Prints a line for each folder, such as "  shape: plane sphere, not box cone". `compiled` is a list of paths
 * with blanks between. */
void library_files_print(const char *library, const char *compiled, Text *out);
