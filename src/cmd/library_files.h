/* The GLSL library's files, and which of them are in a shader. */
#pragma once

#include "base/text.h"

/* A line for each folder: "  shape: plane sphere, not box cone". `compiled` is paths with blanks between. */
void library_files_print(const char *library, const char *compiled, Text *out);
