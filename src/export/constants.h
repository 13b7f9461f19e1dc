/* Makes constants of a text's uniforms, for places that cannot set any. */
#pragma once

#include "base/text.h"
#include "gl/uniforms.h"
#include "source/glsl_tokens.h"
#include "source/text_edits.h"

typedef struct ConstantsParams {
    /* The values. */
    const Uniforms *values;
    /* These become variables with their value, or without one where they have none; ends with NULL. */
    const char *const *variables;
    /* The declarations of these are taken away. */
    const Names *moved;
} ConstantsParams;

/* Adds the edits that make the constants, of all types and of structures. A comment that is to stay begins
 * with "//=" (export/strip.h). A uniform without a value, such as a texture, is STATUS_FAILURE. */
MUST_CHECK bool constants_put(const GlslTokens *tokens, const ConstantsParams *params, TextEdits *edits,
                              Error *error);

/* Appends a number as GLSL ES reads it, with as many digits as a float has: "0.5", "2.1e-05". */
void constants_print_float(Text *text, double value);

/* Appends "vec3(a, b, c)". */
void constants_print_vector(Text *text, const double *values, int count);
