/* Names that two files of a text have for different things: the driver names one of the places. */
#pragma once

#include "source/glsl_source.h"

typedef struct GlslClash {
    char name[80];
    /* The other place: a file's number, and a line of it. */
    int file, line;
} GlslClash;

/* Whether a name on this line of the text (from 1) is declared on it, outside of functions, and in another
 * file too; or whether another file has a macro of a name that stands on it. */
bool glsl_clash_find(const GlslSource *source, int text_line, GlslClash *clash);
