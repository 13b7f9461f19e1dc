#include "source/glsl_tokens.h"

#include "base/memory.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Reader {
    GlslTokens *tokens;
    int file, directive, directives, capacity;
    /* Whether only blanks stand before on this line. */
    bool line_start;
} Reader;

static bool is_word(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

static void add(Reader *reader, GlslTokenKind kind, const char *at, size_t size) {
    GlslTokens *tokens = reader->tokens;
    if (tokens->count == reader->capacity) {
        reader->capacity = reader->capacity ? 2 * reader->capacity : 256;
        tokens->list = memory_grow(tokens->list, (size_t)reader->capacity, sizeof *tokens->list);
    }
    tokens->list[tokens->count++] =
        (GlslToken){kind, (size_t)(at - tokens->text), size, reader->file, reader->directive};
}

/* Behind a comment or a continued line's end; `at` itself where there is neither. */
static const char *skip_comment(const char *at) {
    if (at[0] == '/' && at[1] == '/') return at + strcspn(at, "\n");
    if (at[0] == '/' && at[1] == '*') {
        const char *end = strstr(at + 2, "*/");
        return end ? end + 2 : at + strlen(at);
    }
    if (at[0] == '\\' && at[1] == '\n') return at + 2;
    if (at[0] == '\\' && at[1] == '\r' && at[2] == '\n') return at + 3;
    return at;
}

/* A number with what may belong to it: 1e-3, 0x1Fu, .5, 1.f. */
static size_t number_size(const char *at) {
    size_t size = 1;
    bool hex = at[0] == '0' && (at[1] == 'x' || at[1] == 'X');
    for (; is_word(at[size]) || at[size] == '.'; size++) {
        bool exponent = !hex && (at[size] == 'e' || at[size] == 'E');
        if (exponent && (at[size + 1] == '+' || at[size + 1] == '-')) size++;
    }
    return size;
}

/* Two signs of which one is `=` are one token, so that `=` alone is an initialiser. */
static size_t sign_size(const char *at) {
    return at[1] == '=' && strchr("=!<>+-*/%&|^", at[0]) ? 2 : 1;
}

static const char *read_token(Reader *reader, const char *at) {
    size_t size;
    if (reader->line_start && sscanf(at, "#line %*d %d", &reader->file) == 1) return at + strcspn(at, "\n");
    if (reader->line_start && *at == '#') reader->directive = ++reader->directives;
    reader->line_start = false;
    if (isdigit((unsigned char)*at) || (*at == '.' && isdigit((unsigned char)at[1]))) {
        add(reader, GLSL_NUMBER, at, size = number_size(at));
    } else if (is_word(*at)) {
        for (size = 1; is_word(at[size]);) size++;
        add(reader, GLSL_WORD, at, size);
    } else {
        add(reader, GLSL_SIGN, at, size = sign_size(at));
    }
    return at + size;
}

GlslTokens glsl_tokens(const char *text) {
    GlslTokens tokens = {.text = text};
    Reader reader = {.tokens = &tokens, .line_start = true};
    for (const char *at = text; *at;) {
        const char *behind = skip_comment(at);
        if (behind > at) {
            at = behind;
        } else if (*at == '\n') {
            reader.line_start = true;
            reader.directive = 0;
            at++;
        } else if (isspace((unsigned char)*at)) {
            at++;
        } else {
            at = read_token(&reader, at);
        }
    }
    return tokens;
}

void glsl_tokens_free(GlslTokens *tokens) {
    free(tokens->list);
    *tokens = (GlslTokens){0};
}

bool glsl_token_is(const GlslTokens *tokens, int i, const char *word) {
    if (i < 0 || i >= tokens->count) return false;
    const GlslToken *token = &tokens->list[i];
    return strlen(word) == token->size && strncmp(tokens->text + token->at, word, token->size) == 0;
}

bool glsl_token_among(const GlslTokens *tokens, int i, const char *const *words) {
    for (; *words; words++) {
        if (glsl_token_is(tokens, i, *words)) return true;
    }
    return false;
}

bool glsl_token_is_word(const GlslTokens *tokens, int i) {
    return i >= 0 && i < tokens->count && tokens->list[i].kind == GLSL_WORD;
}

int glsl_token_next(const GlslTokens *tokens, int i) {
    int directive = tokens->list[i].directive;
    for (i++; i < tokens->count; i++) {
        if (tokens->list[i].directive == directive) return i;
        if (directive) break;
    }
    return tokens->count;
}

static int opens(const GlslTokens *tokens, int i) {
    static const char *const opening[] = {"(", "[", "{", NULL}, *const closing[] = {")", "]", "}", NULL};
    return glsl_token_among(tokens, i, opening) - glsl_token_among(tokens, i, closing);
}

int glsl_token_skip(const GlslTokens *tokens, int i) {
    int depth = 0;
    while (i < tokens->count) {
        depth += opens(tokens, i);
        i = glsl_token_next(tokens, i);
        if (!depth) break;
    }
    return i;
}

int glsl_token_find(const GlslTokens *tokens, int i, const char *sign) {
    while (i < tokens->count && !glsl_token_is(tokens, i, sign)) {
        int way = opens(tokens, i);
        if (way < 0) return tokens->count;
        i = way > 0 ? glsl_token_skip(tokens, i) : glsl_token_next(tokens, i);
    }
    return i;
}

int glsl_token_line(const GlslTokens *tokens, int i) {
    const char *end = tokens->text + tokens->list[i].at;
    int line = 1, file;
    for (const char *at = tokens->text; at + strcspn(at, "\n") < end; at += strcspn(at, "\n") + 1) {
        if (strncmp(at, "#line ", 6) != 0 || sscanf(at, "#line %d %d", &line, &file) != 2) line++;
    }
    return line;
}

static bool same(const GlslTokens *tokens, int i, int other) {
    const GlslToken *a = &tokens->list[i], *b = &tokens->list[other];
    return a->size == b->size && memcmp(tokens->text + a->at, tokens->text + b->at, a->size) == 0;
}

bool glsl_token_is_member(const GlslTokens *tokens, int word) {
    for (int i = 0; i < tokens->count; i++) {
        int open = i + (glsl_token_is(tokens, i + 1, "{") ? 1 : 2);
        if (!glsl_token_is(tokens, i, "struct") || !glsl_token_is(tokens, open, "{")) continue;
        int end = glsl_token_skip(tokens, open);
        for (int k = open; k < end; k++) {
            if (same(tokens, k, word)) return true;
        }
    }
    return false;
}
