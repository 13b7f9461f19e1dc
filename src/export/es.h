/* GLSL ES 3.00, which browsers take, from the GLSL 3.30 of a flattened text. The library keeps to what both
 * have in common, so that only the head differs. */
#pragma once

#include "source/glsl_source.h"

/* Checks and changes the user's files in a text, so that compilers of ES take what those of GLSL 3.30 take.
 * Fails with STATUS_SCENE and the place where that cannot be done. `library` is the folder of the library. */
MUST_CHECK bool es_mend(GlslSource *source, const char *library, Error *error);

/* Reads a flattened text piece by piece: a piece is what stands between two #line directives. */
typedef struct EsReader {
    /* Without comments. */
    Text code;
    const char *at;
    bool begun;
} EsReader;

EsReader es_begin(const GlslSource *source);

/* Appends the next piece that is not empty, without comments and without what `#if 0` leaves out. The first
 * one is the head of ES. Returns false where there is none. */
bool es_piece(EsReader *reader, Text *piece);
void es_end(EsReader *reader);

/* Appends the whole text. */
void es_write(const GlslSource *source, Text *out);
