#include "source/glsl_clash.h"

#include "base/memory.h"
#include "source/glsl_tokens.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a word does where it stands. */
typedef enum Role { ROLE_NONE, ROLE_DECLARED, ROLE_MACRO } Role;

typedef struct Search {
    GlslTokens tokens;
    /* Of each token. */
    Role *roles;
    int *lines;
} Search;

/* `i` is outside of functions and parentheses: whether a type stands before it and a declaration's sign
 * behind it. */
static bool is_declared(const GlslTokens *tokens, int i) {
    static const char *const behind[] = {"=", ";", ",", "[", "(", "{", NULL};
    bool typed = i > 0 && !tokens->list[i - 1].directive &&
                 (glsl_token_is_word(tokens, i - 1) || glsl_token_is(tokens, i - 1, "]"));
    return typed && glsl_token_among(tokens, glsl_token_next(tokens, i), behind);
}

static void find_roles(Search *search) {
    const GlslTokens *tokens = &search->tokens;
    const char *at = tokens->text;
    int depth = 0, line = 1;
    for (int i = 0; i < tokens->count; i++) {
        const GlslToken *token = &tokens->list[i];
        for (; at < tokens->text + token->at; at++) line += *at == '\n';
        search->lines[i] = line;
        if (token->directive) {
            bool macro = glsl_token_is(tokens, i - 1, "define") && glsl_token_is(tokens, i - 2, "#");
            search->roles[i] = macro ? ROLE_MACRO : ROLE_NONE;
            continue;
        }
        if (token->kind == GLSL_WORD && !depth && is_declared(tokens, i)) search->roles[i] = ROLE_DECLARED;
        static const char *const open[] = {"{", "(", NULL}, *const close[] = {"}", ")", NULL};
        depth += glsl_token_among(tokens, i, open) - glsl_token_among(tokens, i, close);
    }
}

static bool clashes(const Search *search, int i, int other) {
    const GlslToken *a = &search->tokens.list[i], *b = &search->tokens.list[other];
    const char *text = search->tokens.text;
    if (a->file == b->file || a->size != b->size || memcmp(text + a->at, text + b->at, a->size) != 0)
        return false;
    return search->roles[other] == ROLE_MACRO || (search->roles[i] && search->roles[other]);
}

static bool find(const Search *search, int i, GlslClash *clash) {
    const GlslTokens *tokens = &search->tokens;
    for (int other = 0; other < tokens->count; other++) {
        if (!clashes(search, i, other)) continue;
        *clash = (GlslClash){.file = tokens->list[other].file, .line = glsl_token_line(tokens, other)};
        snprintf(clash->name, sizeof clash->name, "%.*s", (int)tokens->list[i].size,
                 tokens->text + tokens->list[i].at);
        return true;
    }
    return false;
}

bool glsl_clash_find(const GlslSource *source, int text_line, GlslClash *clash) {
    Search search = {.tokens = glsl_tokens(text_string(&source->text))};
    bool found = false;
    search.roles = memory_get((size_t)search.tokens.count + 1, sizeof *search.roles);
    search.lines = memory_get((size_t)search.tokens.count + 1, sizeof *search.lines);
    find_roles(&search);
    for (int i = 0; i < search.tokens.count && !found; i++)
        found = search.lines[i] == text_line && search.tokens.list[i].kind == GLSL_WORD &&
                find(&search, i, clash);
    free(search.roles);
    free(search.lines);
    glsl_tokens_free(&search.tokens);
    return found;
}
