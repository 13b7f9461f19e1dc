#include "source/glsl_tokens.h"

#include "base/memory.h"
#include "source/glsl_line.h"

#include <ctype.h>
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
    tokens->list[tokens->count++] = (GlslToken){.kind = kind,
                                                .at = (size_t)(at - tokens->text),
                                                .size = size,
                                                .file = reader->file,
                                                .directive = reader->directive};
}

const char *glsl_comment_end(const char *at) {
    if (at[0] == '/' && at[1] == '/') return at + strcspn(at, "\n");
    if (at[0] == '/' && at[1] == '*') {
        const char *end = strstr(at + 2, "*/");
        return end ? end + 2 : at + strlen(at);
    }
    return at;
}

/* Behind a comment or a continued line's end; `at` itself where there is neither. */
static const char *skip_comment(const char *at) {
    if (at[0] == '\\' && at[1] == '\n') return at + 2;
    if (at[0] == '\\' && at[1] == '\r' && at[2] == '\n') return at + 3;
    return glsl_comment_end(at);
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
    int line;
    if (reader->line_start && glsl_line_read(at, &line, &reader->file)) return at + strcspn(at, "\n");
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

/* 1 for a bracket that opens, -1 for one that closes. */
static int opens(const GlslTokens *tokens, int i) {
    static const char *const opening[] = {"(", "[", "{", NULL}, *const closing[] = {")", "]", "}", NULL};
    return glsl_token_among(tokens, i, opening) - glsl_token_among(tokens, i, closing);
}

/* Brackets that are open, each by its token. */
typedef struct Stack {
    int *list, count;
} Stack;

static void match(GlslTokens *tokens, int i, Stack *stack) {
    int way = opens(tokens, i);
    tokens->list[i].behind = tokens->count;
    if (way > 0) stack->list[stack->count++] = i;
    if (way < 0 && stack->count)
        tokens->list[stack->list[--stack->count]].behind = glsl_token_next(tokens, i);
}

/* Brackets of the code match each other, and so do those of each directive. */
static void match_all(GlslTokens *tokens) {
    size_t count = (size_t)tokens->count;
    Stack code = {.list = memory_get(count, sizeof(int))},
          directive = {.list = memory_get(count, sizeof(int))};
    for (int i = 0; i < tokens->count; i++) {
        bool begins = i == 0 || tokens->list[i].directive != tokens->list[i - 1].directive;
        if (begins) directive.count = 0;
        match(tokens, i, tokens->list[i].directive ? &directive : &code);
    }
    free(code.list);
    free(directive.list);
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
    match_all(&tokens);
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

int glsl_token_skip(const GlslTokens *tokens, int i) {
    if (i >= tokens->count) return i;
    return opens(tokens, i) > 0 ? tokens->list[i].behind : glsl_token_next(tokens, i);
}

int glsl_token_comma(const GlslTokens *tokens, int i, int end) {
    while (i < end && !glsl_token_is(tokens, i, ",")) {
        if (opens(tokens, i) < 0) return end;
        i = glsl_token_skip(tokens, i);
    }
    return i < end ? i : end;
}

/* What is found is noted at every token on the way, so that no way is gone twice. */
int glsl_token_semicolon(const GlslTokens *tokens, int i) {
    int found = i;
    while (found < tokens->count && !tokens->list[found].semicolon && !glsl_token_is(tokens, found, ";"))
        found = opens(tokens, found) < 0 ? tokens->count : glsl_token_skip(tokens, found);
    if (found < tokens->count && tokens->list[found].semicolon) found = tokens->list[found].semicolon - 1;
    while (i < tokens->count && !tokens->list[i].semicolon) {
        tokens->list[i].semicolon = found + 1;
        i = i == found || opens(tokens, i) < 0 ? tokens->count : glsl_token_skip(tokens, i);
    }
    return found;
}

int glsl_token_line(const GlslTokens *tokens, int i) {
    const char *end = tokens->text + tokens->list[i].at;
    int line = 1, file;
    for (const char *at = tokens->text; at + strcspn(at, "\n") < end; at += strcspn(at, "\n") + 1) {
        if (!glsl_line_read(at, &line, &file)) line++;
    }
    return line;
}

void glsl_token_members(const GlslTokens *tokens, Names *members) {
    for (int i = 0, end = 0; i < tokens->count; i++) {
        int open = i + (glsl_token_is(tokens, i + 1, "{") ? 1 : 2);
        if (glsl_token_is(tokens, i, "struct") && glsl_token_is(tokens, open, "{")) {
            int behind = glsl_token_skip(tokens, open);
            if (behind > end) end = behind;
        }
        const GlslToken *token = &tokens->list[i];
        if (i < end && token->kind == GLSL_WORD) names_add(members, tokens->text + token->at, token->size);
    }
}
