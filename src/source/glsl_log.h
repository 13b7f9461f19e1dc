/* A flattened text for the driver, and the driver's words about it in terms of the files. */
#pragma once

#include "source/glsl_source.h"

/* The text for the driver, to be freed: each #line is made a comment. Mesa forgets which file a #line named,
 * so that lines are counted through the whole text and looked up in it. */
char *glsl_source_plain(const GlslSource *source);

/* The file, by its number, and the line there that a line of the text came from; false where that is no
 * file's. */
bool glsl_source_place(const GlslSource *source, int line, int *file, int *number);

/* Appends to `warnings` what a driver's log on the plain text says of variables that are read before they are
 * set, a line each: "scenes/a.glsl:14: words". */
void glsl_source_warnings(const GlslSource *source, const char *log, Text *warnings);

/* Turns a driver's log on the plain text into an error: each "0:514(3): error: words" becomes
 * "scenes/a.glsl:14: words". */
void glsl_source_explain(const GlslSource *source, const char *log, Error *error);
