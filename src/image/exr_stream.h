/* An EXR file as OpenEXR sees it: bytes in memory. */
#pragma once

#include "base/text.h"

#include <openexr.h>

/* One of `in` and `out` is NULL. */
typedef struct ExrStream {
    const Text *in;
    Text *out;
    /* Where the file begins in `out`. */
    size_t start;
} ExrStream;

/* What OpenEXR is opened with. Its complaints are kept for exr_reason(), and forgotten by the next call. */
exr_context_initializer_t exr_settings(ExrStream *stream);

/* Why OpenEXR failed, in one line. */
const char *exr_reason(exr_result_t code);

/* Fails with STATUS_FAILURE and exr_reason(). */
bool exr_broken(exr_result_t code, const char *path, Error *error);

/* Names out of a broken file may hold anything; an error is one line. */
void exr_line_clean(char *line);
