/* The inputs of Shadertoy programs, and the names that other sites and editors give them. */
#pragma once

#include "source/glsl_tokens.h"

typedef struct ToyInput {
    const char *name, *type;
    /* The GLSL expression of its value; NULL for Shadertoy's own inputs, which
     * glsl/pass/shadertoy_uniforms.glsl declares. */
    const char *value;
} ToyInput;

/* The input of the name that stands at token `i`, or NULL. */
const ToyInput *toy_input_find(const GlslTokens *tokens, int i);
