/* The metadata of an EXR file. */
#pragma once

#include "base/text.h"

/* Appends the metadata of that name, of the first part that has it; false where the bytes are no such file or
 * there is no such line. */
MUST_CHECK bool exr_attribute(const Text *file, const char *name, Text *value);
