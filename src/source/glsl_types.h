/* The types that a GLSL text may use for variables: those of the language, its own structures, and macros
 * that stand for one of these. */
#pragma once

#include "base/names.h"
#include "source/glsl_tokens.h"

typedef struct GlslTypes {
    /* Of structures and macros. */
    Names names;
    /* Whether a function shadertoy_zero_NAME() gives a structure's zero; else NAME(0) does. */
    bool *by_function;
} GlslTypes;

/* A zeroed list knows the types of the language. */
void glsl_types_add(GlslTypes *types, const GlslTokens *tokens, int name, bool by_function);
void glsl_types_free(GlslTypes *types);

bool glsl_types_has(const GlslTypes *types, const GlslTokens *tokens, int i);

/* The GLSL expression of the type's zero, such as "vec3(0)", to be freed. */
char *glsl_types_zero(const GlslTypes *types, const GlslTokens *tokens, int i);
