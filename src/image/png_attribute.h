/* The metadata of a PNG file. */
#pragma once

#include "base/text.h"

/* Appends the metadata of that name, if it stands in front of the pixels; false where there is no such file
 * or line. */
bool png_attribute(const char *path, const char *name, Text *value);
