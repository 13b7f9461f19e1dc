#include "source/glsl_uniforms.h"

#include "base/memory.h"
#include "source/glsl_line.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char keyword[] = "uniform";

static bool is_word(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

/* Behind blanks, comments and nothing else. */
static const char *skip_blanks(const char *at) {
    for (;;) {
        if (isspace((unsigned char)*at)) {
            at++;
        } else if (at[0] == '/' && at[1] == '/') {
            at += strcspn(at, "\n");
        } else if (at[0] == '/' && at[1] == '*') {
            const char *end = strstr(at + 2, "*/");
            at = end ? end + 2 : at + strlen(at);
        } else {
            return at;
        }
    }
}

/* Copies the word at `at`, cut to the target's size, and returns what follows it. */
static const char *take_word(const char *at, char *word, size_t size) {
    size_t length = 0;
    while (is_word(at[length])) length++;
    snprintf(word, size, "%.*s", (int)length, at);
    return at + length;
}

/* How far lines have been counted, from the last #line on. */
typedef struct Place {
    const char *at;
    int file, line;
} Place;

static GlslUniform *add(GlslUniforms *uniforms, const char *type, const char *name, Place *place,
                        const char *at) {
    GlslUniform *uniform;
    uniforms->items = memory_grow(uniforms->items, (size_t)uniforms->count + 1, sizeof *uniforms->items);
    uniform = &uniforms->items[uniforms->count++];
    for (; place->at < at; place->at++) place->line += *place->at == '\n';
    *uniform = (GlslUniform){.file = place->file, .line = place->line};
    snprintf(uniform->type, sizeof uniform->type, "%s", type);
    snprintf(uniform->name, sizeof uniform->name, "%s", name);
    return uniform;
}

/* `at` stands behind the "=" of a declaration. Returns the comma or semicolon that ends the value. */
static const char *skip_value(const char *at) {
    for (int depth = 0; *at && *at != ';' && !(*at == ',' && depth == 0); at++)
        depth += (*at == '(' || *at == '{' || *at == '[') - (*at == ')' || *at == '}' || *at == ']');
    return at;
}

static bool is_precision(const char *word) {
    return strcmp(word, "lowp") == 0 || strcmp(word, "mediump") == 0 || strcmp(word, "highp") == 0;
}

/* `at` stands behind the word `uniform`. Returns what follows the declaration's names. */
static const char *take_declaration(const char *at, Place *place, GlslUniforms *uniforms) {
    char type[32], name[64];
    do at = take_word(skip_blanks(at), type, sizeof type);
    while (is_precision(type));
    for (;;) {
        const char *start = skip_blanks(at);
        at = take_word(start, name, sizeof name);
        if (!name[0]) return at;
        GlslUniform *uniform = add(uniforms, type, name, place, start);
        at = skip_blanks(at);
        if (*at == '[') at = skip_blanks(at + strcspn(at, "];"));
        if (*at == ']') at = skip_blanks(at + 1);
        uniform->has_value = *at == '=';
        if (*at == '=') at = skip_value(at + 1);
        if (*at != ',') return at;
        at++;
    }
}

GlslUniforms glsl_uniforms(const char *text) {
    GlslUniforms uniforms = {0};
    Place place = {.at = text, .line = 1};
    bool line_start = true;
    for (const char *at = text; *at;) {
        const char *next = skip_blanks(at);
        line_start = line_start || memchr(at, '\n', (size_t)(next - at)) != NULL;
        at = next;
        if (!*at) break;
        if (line_start && glsl_line_read(at, &place.line, &place.file)) {
            at += strcspn(at, "\n");
            place.at = *at ? at + 1 : at;
            continue;
        }
        line_start = false;
        if (!is_word(*at)) {
            at++;
            continue;
        }
        char word[16];
        at = take_word(at, word, sizeof word);
        if (strcmp(word, keyword) == 0) at = take_declaration(at, &place, &uniforms);
    }
    return uniforms;
}

void glsl_uniforms_free(GlslUniforms *uniforms) {
    free(uniforms->items);
    *uniforms = (GlslUniforms){0};
}

const GlslUniform *glsl_uniforms_find(const GlslUniforms *uniforms, const char *name) {
    for (int i = 0; i < uniforms->count; i++) {
        if (strcmp(uniforms->items[i].name, name) == 0) return &uniforms->items[i];
    }
    return NULL;
}
