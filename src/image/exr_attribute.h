/* The metadata of an EXR file. */
#pragma once

#include "base/text.h"
#include "image/attribute.h"

/* Appends the metadata of that name, of the first part that has it; false where the bytes are no such file or
 * there is no such line. */
MUST_CHECK bool exr_attribute(const Text *file, const char *name, Text *value);

/* Adds all metadata of the first part that are text. False where the bytes are no such file. */
MUST_CHECK bool exr_attributes(const Text *file, AttributeList *list);

/* Appends lines about the file: the size and the channels of each part, and its metadata that are text, as
 * "name: value". False where the bytes are no such file. */
MUST_CHECK bool exr_describe(const Text *file, Text *lines);
