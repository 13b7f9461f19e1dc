/* GLSL 3.30 makes a float of a whole number where one is wanted, and GLSL ES does not. */
#pragma once

#include "source/glsl_tokens.h"
#include "source/text_edits.h"

/* Adds the edits that put ".0" behind whole numbers of the user's files where a float is wanted for certain:
 * the value of a float, an operand beside a float or a vector, and an argument for a float. `library` is the
 * folder of the library. */
void whole_numbers_mend(const GlslSource *source, const char *library, const GlslTokens *tokens,
                        TextEdits *edits);
