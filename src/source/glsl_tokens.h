/* The tokens of a flattened GLSL text, with their places: comments are none, and directives are marked. */
#pragma once

#include "base/names.h"
#include "source/glsl_source.h"

typedef enum GlslTokenKind { GLSL_WORD, GLSL_NUMBER, GLSL_SIGN } GlslTokenKind;

typedef struct GlslToken {
    GlslTokenKind kind;
    /* Where it stands in the text, in bytes. */
    size_t at, size;
    /* The file that it comes from, by the last #line before it. */
    int file;
    /* 0 in code. Tokens of the same directive, such as `#define`, have the same number. */
    int directive;
    /* Of a bracket that opens: the token behind the one that closes it, or the list's count. */
    int behind;
    /* What glsl_token_semicolon() found from here, from 1; 0 where it was not asked. */
    int semicolon;
} GlslToken;

typedef struct GlslTokens {
    /* Borrowed. */
    const char *text;
    GlslToken *list;
    int count;
} GlslTokens;

/* Splits the text, which has to outlive the list. #line directives are obeyed and left out. To be freed. */
GlslTokens glsl_tokens(const char *text);
void glsl_tokens_free(GlslTokens *tokens);

/* Behind the comment that begins at `at`, before the line's end after two slashes; `at` itself where none
 * begins. */
const char *glsl_comment_end(const char *at);

/* Whether token `i` is this word or sign. There is none past the ends. */
bool glsl_token_is(const GlslTokens *tokens, int i, const char *word);

/* Whether it is one of these words; the list ends with NULL. */
bool glsl_token_among(const GlslTokens *tokens, int i, const char *const *words);

bool glsl_token_is_word(const GlslTokens *tokens, int i);

/* The next token of the same directive, or of the code, behind `i`; `count` where there is none. */
int glsl_token_next(const GlslTokens *tokens, int i);

/* The token behind the bracket that closes the one at `i`, or `count`. Brackets of all kinds nest. */
int glsl_token_skip(const GlslTokens *tokens, int i);

/* The first token of the same directive, or of the code, from `i` on that is a semicolon outside of brackets.
 * A closing bracket ends the search. `count` where there is none. */
int glsl_token_semicolon(const GlslTokens *tokens, int i);

/* The same for a comma before token `end`, which is given where there is none. */
int glsl_token_comma(const GlslTokens *tokens, int i, int end);

/* The line of its file on which the token stands. */
int glsl_token_line(const GlslTokens *tokens, int i);

/* Adds every word that stands among the members of a structure. */
void glsl_token_members(const GlslTokens *tokens, Names *members);
