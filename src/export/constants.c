#include "export/constants.h"

#include "source/glsl_scan.h"
#include "source/glsl_uniforms.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NAME = 160 };

/* A declaration `uniform TYPE NAME[SIZE];` by its tokens. */
typedef struct Declaration {
    int start, type, name, end;
} Declaration;

typedef struct Writer {
    const GlslTokens *tokens;
    const ConstantsParams *params;
    Text *text;
} Writer;

void constants_print_float(Text *text, double value) {
    char number[40];
    int digits = 6;
    do snprintf(number, sizeof number, "%.*g", digits, (double)(float)value);
    while (strtof(number, NULL) != (float)value && ++digits <= 9);
    bool whole = fabs(value) < 1e9 && (float)value == roundf((float)value);
    if (whole) snprintf(number, sizeof number, "%.0f", value == 0 ? 0 : value);
    text_print(text, "%s%s", number, strpbrk(number, ".en") ? "" : ".0");
}

void constants_print_vector(Text *text, const double *values, int count) {
    text_print(text, "vec%d(", count);
    for (int i = 0; i < count; i++) {
        text_print(text, "%s", i ? ", " : "");
        constants_print_float(text, values[i]);
    }
    text_print(text, ")");
}

static char *copy_word(const GlslTokens *tokens, int i, char word[MOST_NAME]) {
    const GlslToken *token = &tokens->list[i];
    snprintf(word, MOST_NAME, "%.*s", (int)token->size, tokens->text + token->at);
    return word;
}

static const Uniform *find(const Uniforms *uniforms, const char *name) {
    for (int i = 0; i < uniforms->count; i++) {
        if (strcmp(uniforms->items[i].name, name) == 0) return &uniforms->items[i];
    }
    return NULL;
}

static void print_floats(Text *text, const double *values, int count) {
    text_print(text, "float[%d](", count);
    for (int i = 0; i < count; i++) {
        text_print(text, "%s", i ? ", " : "");
        constants_print_float(text, values[i]);
    }
    text_print(text, ")");
}

static void print_value(Text *text, const Uniform *uniform, const char *type) {
    switch (uniform->type) {
    case UNIFORM_FLOAT:
        constants_print_float(text, uniform->values[0]);
        break;
    case UNIFORM_INT:
        if (strcmp(type, "bool") == 0)
            text_print(text, "%s", uniform->values[0] != 0 ? "true" : "false");
        else
            text_print(text, "%.0f", uniform->values[0]);
        break;
    case UNIFORM_UINT:
        text_print(text, "%.0fu", uniform->values[0]);
        break;
    case UNIFORM_VEC3:
        constants_print_vector(text, uniform->values, 3);
        break;
    case UNIFORM_VEC4:
        constants_print_vector(text, uniform->values, 4);
        break;
    case UNIFORM_FLOATS:
        print_floats(text, uniform->many, uniform->count);
        break;
    }
}

/* The token behind the `{` of the structure of that name; -1 where there is none. */
static int structure_body(const GlslTokens *tokens, const char *type) {
    for (int i = 0; i + 2 < tokens->count; i++) {
        if (glsl_token_is(tokens, i, "struct") && glsl_token_is(tokens, i + 1, type)) return i + 3;
    }
    return -1;
}

/* Writes `TYPE(a, b, ...)` with each member on a line of its own. */
static bool print_structure(Writer *writer, const char *type, const char *name) {
    const GlslTokens *tokens = writer->tokens;
    int i = structure_body(tokens, type);
    if (i < 0) return false;
    text_print(writer->text, "%s(", type);
    while (i + 1 < tokens->count && !glsl_token_is(tokens, i, "}")) {
        char member[MOST_NAME], member_type[MOST_NAME], full[2 * MOST_NAME + 2];
        copy_word(tokens, i, member_type);
        copy_word(tokens, i + 1, member);
        snprintf(full, sizeof full, "%s.%s", name, member);
        const Uniform *value = find(writer->params->values, full);
        if (!value) return false;
        while (i < tokens->count && !glsl_token_is(tokens, i, ";")) i++;
        bool last = glsl_token_is(tokens, ++i, "}");
        text_print(writer->text, "\n    ");
        print_value(writer->text, value, member_type);
        text_print(writer->text, "%s  //= %s", last ? "" : ",", member);
    }
    text_print(writer->text, "\n)");
    return true;
}

/* Writes `TYPE[](a, b, ...)` for an array whose elements are uniforms of their own. */
static bool print_elements(Writer *writer, const char *type, const char *name) {
    char full[MOST_NAME + 16];
    int count = 0;
    text_print(writer->text, "%s[](", type);
    for (;; count++) {
        snprintf(full, sizeof full, "%s[%d]", name, count);
        const Uniform *value = find(writer->params->values, full);
        if (!value) break;
        text_print(writer->text, "%s", count ? ", " : "");
        print_value(writer->text, value, type);
    }
    text_print(writer->text, ")");
    return count > 0;
}

static bool is_variable(const Writer *writer, const char *name) {
    for (const char *const *variable = writer->params->variables; *variable; variable++) {
        if (strcmp(*variable, name) == 0) return true;
    }
    return false;
}

/* Writes what stands in place of `uniform TYPE NAME;`, without the semicolon. */
static bool print_constant(Writer *writer, const Declaration *declaration) {
    char type[MOST_NAME], name[MOST_NAME];
    const GlslTokens *tokens = writer->tokens;
    copy_word(tokens, declaration->type, type);
    copy_word(tokens, declaration->name, name);
    size_t from = tokens->list[declaration->type].at, to = tokens->list[declaration->end].at;
    const Uniform *value = find(writer->params->values, name);
    bool variable = is_variable(writer, name);
    text_print(writer->text, "%s%.*s", variable ? "" : "const ", (int)(to - from), tokens->text + from);
    if (variable) return true;
    text_print(writer->text, " = ");
    if (value) {
        print_value(writer->text, value, type);
        return true;
    }
    return glsl_token_is(tokens, declaration->name + 1, "[") ? print_elements(writer, type, name)
                                                             : print_structure(writer, type, name);
}

static bool put(const GlslTokens *tokens, const ConstantsParams *params, const Declaration *declaration,
                TextEdits *edits, Error *error) {
    Text text = {0};
    Writer writer = {tokens, params, &text};
    const GlslToken *name = &tokens->list[declaration->name];
    size_t from = tokens->list[declaration->start].at, to = tokens->list[declaration->end].at;
    bool own_value = glsl_token_is(tokens, declaration->name + 1, "=");
    if (names_find(params->moved, tokens->text + name->at, name->size) >= 0) {
        text_edits_add(edits, from, to + 1 - from, "%s", "");
        return true;
    }
    if (own_value) {
        text_edits_add(edits, from, tokens->list[declaration->start].size, "const");
        return true;
    }
    bool ok = print_constant(&writer, declaration);
    if (ok) text_edits_add(edits, from, to - from, "%s", text_string(&text));
    text_free(&text);
    if (ok) return true;
    return error_set(error, STATUS_FAILURE, "the uniform %.*s has no value that a text can hold",
                     (int)name->size, tokens->text + name->at);
}

/* The names of the uniforms that `#if 0` does not leave out. */
static void find_declared(const GlslTokens *tokens, Names *declared) {
    GlslScan scan = glsl_scan(tokens->text);
    GlslUniforms uniforms = glsl_uniforms(scan.code);
    for (int i = 0; i < uniforms.count; i++)
        names_add(declared, uniforms.items[i].name, strlen(uniforms.items[i].name));
    glsl_uniforms_free(&uniforms);
    glsl_scan_free(&scan);
}

bool constants_put(const GlslTokens *tokens, const ConstantsParams *params, TextEdits *edits, Error *error) {
    static const char *const precisions[] = {"highp", "mediump", "lowp", NULL};
    Names declared = {0};
    bool ok = true;
    find_declared(tokens, &declared);
    for (int i = 0; ok && i + 3 < tokens->count; i++) {
        if (!glsl_token_is(tokens, i, "uniform") || tokens->list[i].directive) continue;
        int type = glsl_token_among(tokens, i + 1, precisions) ? i + 2 : i + 1;
        Declaration declaration = {i, type, type + 1, glsl_token_semicolon(tokens, i)};
        const GlslToken *name = &tokens->list[type + 1];
        if (declaration.end < tokens->count &&
            names_find(&declared, tokens->text + name->at, name->size) >= 0)
            ok = put(tokens, params, &declaration, edits, error);
    }
    names_free(&declared);
    return ok;
}
