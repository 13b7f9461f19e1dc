/* The metadata of a PNG file. */
#pragma once

#include "base/text.h"

/* Appends the metadata of that name, if it stands in front of the pixels; false where the bytes are no
 * PNG or there is no such line. */
bool png_attribute(const Text *file, const char *name, Text *value);

/* Appends lines about the file: its size, and its metadata as "name: value". False where the bytes are no
 * PNG. */
bool png_describe(const Text *file, Text *lines);
