#include "export/toy_names.h"

#include "export/users.h"

#include <stdio.h>
#include <string.h>

const char *const toy_inputs[] = {"iResolution", "iTime", "iFrame", "iMouse", NULL};

/* What the site writes around a tab, and the words that GLSL ES 3.00 has and GLSL 3.30 has not. */
static const char *const taken[] = {"iResolution",
                                    "iTime",
                                    "iTimeDelta",
                                    "iFrameRate",
                                    "iFrame",
                                    "iChannelTime",
                                    "iChannelResolution",
                                    "iMouse",
                                    "iDate",
                                    "iSampleRate",
                                    "iChannel0",
                                    "iChannel1",
                                    "iChannel2",
                                    "iChannel3",
                                    "iCh0",
                                    "iCh1",
                                    "iCh2",
                                    "iCh3",
                                    "HW_PERFORMANCE",
                                    "outColor",
                                    "shadertoy_out_color",
                                    "st_assert",
                                    "main",
                                    "mainImage",
                                    "mainSound",
                                    "mainVR",
                                    "mainCubemap",
                                    "attribute",
                                    "varying",
                                    "coherent",
                                    "volatile",
                                    "restrict",
                                    "readonly",
                                    "writeonly",
                                    "resource",
                                    "atomic_uint",
                                    "patch",
                                    "sample",
                                    "subroutine",
                                    "precise",
                                    "texture2D",
                                    "superp",
                                    NULL};

/* The functions of GLSL ES 3.00 that somebody may want to define anew. */
static const char *const built_in[] = {"radians",
                                       "degrees",
                                       "sin",
                                       "cos",
                                       "tan",
                                       "asin",
                                       "acos",
                                       "atan",
                                       "sinh",
                                       "cosh",
                                       "tanh",
                                       "asinh",
                                       "acosh",
                                       "atanh",
                                       "pow",
                                       "exp",
                                       "log",
                                       "exp2",
                                       "log2",
                                       "sqrt",
                                       "inversesqrt",
                                       "abs",
                                       "sign",
                                       "floor",
                                       "trunc",
                                       "round",
                                       "roundEven",
                                       "ceil",
                                       "fract",
                                       "mod",
                                       "modf",
                                       "min",
                                       "max",
                                       "clamp",
                                       "mix",
                                       "step",
                                       "smoothstep",
                                       "isnan",
                                       "isinf",
                                       "floatBitsToInt",
                                       "floatBitsToUint",
                                       "intBitsToFloat",
                                       "uintBitsToFloat",
                                       "packSnorm2x16",
                                       "unpackSnorm2x16",
                                       "packUnorm2x16",
                                       "unpackUnorm2x16",
                                       "packHalf2x16",
                                       "unpackHalf2x16",
                                       "length",
                                       "distance",
                                       "dot",
                                       "cross",
                                       "normalize",
                                       "faceforward",
                                       "reflect",
                                       "refract",
                                       "matrixCompMult",
                                       "outerProduct",
                                       "transpose",
                                       "determinant",
                                       "inverse",
                                       "lessThan",
                                       "lessThanEqual",
                                       "greaterThan",
                                       "greaterThanEqual",
                                       "equal",
                                       "notEqual",
                                       "any",
                                       "all",
                                       "not",
                                       "textureSize",
                                       "texture",
                                       "textureProj",
                                       "textureLod",
                                       "textureOffset",
                                       "texelFetch",
                                       "texelFetchOffset",
                                       "textureGrad",
                                       "dFdx",
                                       "dFdy",
                                       "fwidth",
                                       NULL};

bool toy_names_has_input(const GlslTokens *tokens, const char *input) {
    for (int i = 0; i + 2 < tokens->count; i++) {
        if (glsl_token_is(tokens, i, "uniform") &&
            (glsl_token_is(tokens, i + 2, input) || glsl_token_is(tokens, i + 3, input)))
            return true;
    }
    return false;
}

static bool is_own(const ToyNames *names, int i) {
    return export_is_users(names->source, names->tokens->list[i].file, names->file->sources->folder);
}

/* Adds the names that a text declares outside of functions. */
static void add_declared(const char *text, Names *reserved) {
    GlslTokens tokens = glsl_tokens(text);
    for (int i = 0; i + 2 < tokens.count;) {
        bool bracket = glsl_token_is(&tokens, i, "(") || glsl_token_is(&tokens, i, "{");
        bool declares = glsl_token_is_word(&tokens, i) && glsl_token_is_word(&tokens, i + 1) &&
                        (glsl_token_is(&tokens, i + 2, "(") || glsl_token_is(&tokens, i + 2, "=") ||
                         glsl_token_is(&tokens, i + 2, ";"));
        const GlslToken *name = &tokens.list[i + 1];
        if (declares) names_add(reserved, tokens.text + name->at, name->size);
        i = bracket ? glsl_token_skip(&tokens, i) : i + 1;
    }
    glsl_tokens_free(&tokens);
}

/* Whether a function is defined or declared whose name is token `i`. */
static bool declares_function(const GlslTokens *tokens, int i) {
    if (!i || !glsl_token_is_word(tokens, i - 1) || !glsl_token_is(tokens, i + 1, "(")) return false;
    int behind = glsl_token_skip(tokens, i + 1);
    return !glsl_token_is(tokens, i - 1, "return") && !glsl_token_is(tokens, i - 1, "else") &&
           (glsl_token_is(tokens, behind, "{") || glsl_token_is(tokens, behind, ";"));
}

static bool refuse_function(const ToyNames *names, int i, Error *error) {
    const GlslToken *token = &names->tokens->list[i];
    return error_set(error, STATUS_SCENE,
                     "%s:%d: %.*s() is a function of GLSL ES, where no other one may have its name: call it "
                     "my_%.*s() for Shadertoy",
                     glsl_source_file(names->source, token->file), glsl_token_line(names->tokens, i),
                     (int)token->size, names->tokens->text + token->at, (int)token->size,
                     names->tokens->text + token->at);
}

/* Adds those of the reserved names that stand in the user's files. */
static bool find_clashes(const ToyNames *names, const Names *reserved, Names *clashes, Error *error) {
    const GlslTokens *tokens = names->tokens;
    for (int i = 0; i < tokens->count; i++) {
        const GlslToken *token = &tokens->list[i];
        const char *word = tokens->text + token->at;
        if (token->kind != GLSL_WORD || !is_own(names, i)) continue;
        if (glsl_token_among(tokens, i, built_in) && !token->directive && declares_function(tokens, i))
            return refuse_function(names, i, error);
        if (names_find(reserved, word, token->size) >= 0) names_add(clashes, word, token->size);
    }
    return true;
}

/* The library has none of the clashing names, but what the host writes of the scene has. */
static void rename_words(const GlslTokens *tokens, const Names *clashes, TextEdits *edits) {
    bool inputs[8] = {0};
    for (int k = 0; toy_inputs[k]; k++) inputs[k] = toy_names_has_input(tokens, toy_inputs[k]);
    for (int i = 0; i < tokens->count; i++) {
        const GlslToken *token = &tokens->list[i];
        if (token->kind != GLSL_WORD) continue;
        const char *prefix = names_find(clashes, tokens->text + token->at, token->size) >= 0 ? "own_" : NULL;
        for (int k = 0; toy_inputs[k]; k++) {
            if (inputs[k] && glsl_token_is(tokens, i, toy_inputs[k])) prefix = "scene_";
        }
        if (prefix) text_edits_add(edits, token->at, 0, "%s", prefix);
    }
}

bool toy_names_put(const ToyNames *names, TextEdits *edits, Error *error) {
    Names reserved = {0}, clashes = {0};
    for (int i = 0; taken[i]; i++) names_add(&reserved, taken[i], strlen(taken[i]));
    add_declared(names->others, &reserved);
    bool ok = find_clashes(names, &reserved, &clashes, error);
    if (ok) rename_words(names->tokens, &clashes, edits);
    names_free(&reserved);
    names_free(&clashes);
    return ok;
}
