/* The metadata of an EXR file. */
#pragma once

#include "base/text.h"

/* Appends the metadata of that name, of the first part that has it; false where there is no such file or
 * line. */
MUST_CHECK bool exr_attribute(const char *path, const char *name, Text *value);
