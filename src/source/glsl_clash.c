#include "source/glsl_clash.h"

#include "base/memory.h"
#include "source/glsl_tokens.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a word does where it stands. */
typedef enum Role { ROLE_NONE, ROLE_DECLARED, ROLE_MACRO } Role;

/* The first token of a word, and the first in another file than that one's; -1 where there is none. */
typedef struct Firsts {
    int first, second;
} Firsts;

/* Where a word is declared or is a macro, and where it is a macro. */
typedef struct Word {
    Firsts named, macros;
} Word;

typedef struct Search {
    GlslTokens tokens;
    /* Of each token. */
    Role *roles;
    int *lines;
    /* The words that have a role somewhere, and where. */
    Names names;
    Word *words;
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

/* Notes a token as the first of its word, or as the first of another file than that of the first. */
static void note(const Search *search, Firsts *firsts, int i) {
    if (firsts->first < 0)
        firsts->first = i;
    else if (firsts->second < 0 && search->tokens.list[firsts->first].file != search->tokens.list[i].file)
        firsts->second = i;
}

/* The first of another file than that of token `i`, or the count of tokens. */
static int first_elsewhere(const Search *search, const Firsts *firsts, int i) {
    const GlslToken *list = search->tokens.list;
    int found =
        firsts->first >= 0 && list[firsts->first].file != list[i].file ? firsts->first : firsts->second;
    return found < 0 ? search->tokens.count : found;
}

static void note_all(Search *search) {
    for (int i = 0; i < search->tokens.count; i++) {
        const GlslToken *token = &search->tokens.list[i];
        if (!search->roles[i]) continue;
        int before = search->names.count,
            word = names_add(&search->names, search->tokens.text + token->at, token->size);
        if (word == before) {
            search->words = memory_grow(search->words, (size_t)word + 1, sizeof *search->words);
            search->words[word] = (Word){{-1, -1}, {-1, -1}};
        }
        note(search, &search->words[word].named, i);
        if (search->roles[i] == ROLE_MACRO) note(search, &search->words[word].macros, i);
    }
}

static bool find(const Search *search, int i, GlslClash *clash) {
    const GlslTokens *tokens = &search->tokens;
    const GlslToken *token = &tokens->list[i];
    int word = names_find(&search->names, tokens->text + token->at, token->size);
    if (word < 0) return false;
    int macro = first_elsewhere(search, &search->words[word].macros, i),
        named = search->roles[i] ? first_elsewhere(search, &search->words[word].named, i) : tokens->count,
        other = macro < named ? macro : named;
    if (other == tokens->count) return false;
    *clash = (GlslClash){.file = tokens->list[other].file, .line = glsl_token_line(tokens, other)};
    snprintf(clash->name, sizeof clash->name, "%.*s", (int)token->size, tokens->text + token->at);
    return true;
}

bool glsl_clash_find(const GlslSource *source, int text_line, GlslClash *clash) {
    Search search = {.tokens = glsl_tokens(text_string(&source->text))};
    bool found = false;
    search.roles = memory_get((size_t)search.tokens.count + 1, sizeof *search.roles);
    search.lines = memory_get((size_t)search.tokens.count + 1, sizeof *search.lines);
    find_roles(&search);
    note_all(&search);
    for (int i = 0; i < search.tokens.count && !found; i++)
        found = search.lines[i] == text_line && search.tokens.list[i].kind == GLSL_WORD &&
                find(&search, i, clash);
    free(search.roles);
    free(search.lines);
    free(search.words);
    names_free(&search.names);
    glsl_tokens_free(&search.tokens);
    return found;
}
