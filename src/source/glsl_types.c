#include "source/glsl_types.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

static const char *const language[] = {
    "float",  "int",    "uint",   "bool",   "vec2",   "vec3",   "vec4",   "ivec2",  "ivec3", "ivec4",
    "uvec2",  "uvec3",  "uvec4",  "bvec2",  "bvec3",  "bvec4",  "mat2",   "mat3",   "mat4",  "mat2x2",
    "mat2x3", "mat2x4", "mat3x2", "mat3x3", "mat3x4", "mat4x2", "mat4x3", "mat4x4", NULL};

static int find(const GlslTypes *types, const GlslTokens *tokens, int i) {
    if (i < 0 || i >= tokens->count) return -1;
    const GlslToken *token = &tokens->list[i];
    return names_find(&types->names, tokens->text + token->at, token->size);
}

void glsl_types_add(GlslTypes *types, const GlslTokens *tokens, int name, bool by_function) {
    const GlslToken *token = &tokens->list[name];
    int before = types->names.count, number = names_add(&types->names, tokens->text + token->at, token->size);
    /* The first of two of the same name stays. */
    if (number < before) return;
    types->by_function =
        memory_grow(types->by_function, (size_t)types->names.count, sizeof *types->by_function);
    types->by_function[number] = by_function;
}

void glsl_types_free(GlslTypes *types) {
    names_free(&types->names);
    free(types->by_function);
    *types = (GlslTypes){0};
}

bool glsl_types_has(const GlslTypes *types, const GlslTokens *tokens, int i) {
    return glsl_token_among(tokens, i, language) || find(types, tokens, i) >= 0;
}

char *glsl_types_zero(const GlslTypes *types, const GlslTokens *tokens, int i) {
    const GlslToken *token = &tokens->list[i];
    int own = find(types, tokens, i);
    bool by_function = own >= 0 && types->by_function[own];
    Text zero = {0};
    text_print(&zero, by_function ? "shadertoy_zero_%.*s()" : "%.*s(0)", (int)token->size,
               tokens->text + token->at);
    return zero.data;
}
