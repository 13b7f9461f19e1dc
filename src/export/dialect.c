#include "export/dialect.h"

#include "source/glsl_tokens.h"
#include "source/text_edits.h"

#include <string.h>

static const char *const words[][2] = {{"INOUT", "inout"}, {"OUT", "out"}, {"IN", "in"}, {NULL, NULL}};

static const char *word_of(const GlslTokens *tokens, int i) {
    for (int k = 0; words[k][0]; k++) {
        if (glsl_token_is(tokens, i, words[k][0]) && glsl_token_is(tokens, i + 1, "(") &&
            glsl_token_is(tokens, i + 3, ")"))
            return words[k][1];
    }
    return NULL;
}

static bool is_macros(const GlslSource *source, int file) {
    static const char name[] = "/math/dialect.glsl";
    const char *path = glsl_source_file(source, file);
    size_t size = strlen(path), end = sizeof name - 1;
    return size > end && strcmp(path + size - end, name) == 0;
}

static void take(const GlslTokens *tokens, int from, int to, TextEdits *edits) {
    size_t at = tokens->list[from].at;
    text_edits_add(edits, at, tokens->list[to].at + tokens->list[to].size - at, "%s", "");
}

/* Whether a directive of another file than the macros' own uses one of them. */
static bool is_needed(const GlslSource *source, const GlslTokens *tokens) {
    for (int i = 0; i < tokens->count; i++) {
        bool named = word_of(tokens, i) || glsl_token_is(tokens, i, "assert");
        if (tokens->list[i].directive && named && !is_macros(source, tokens->list[i].file)) return true;
    }
    return false;
}

/* Takes the directive away whose first token is `i`. */
static void take_directive(const GlslTokens *tokens, int i, TextEdits *edits) {
    int last = i;
    while (last + 1 < tokens->count && tokens->list[last + 1].directive == tokens->list[i].directive) last++;
    take(tokens, i, last, edits);
}

static void expand(const GlslTokens *tokens, int i, TextEdits *edits) {
    const char *word = word_of(tokens, i);
    bool statement = glsl_token_is(tokens, i, "assert") && glsl_token_is(tokens, i + 1, "(");
    int end = statement ? glsl_token_skip(tokens, i + 1) : 0;
    if (word) {
        const GlslToken *type = &tokens->list[i + 2];
        text_edits_add(edits, tokens->list[i].at, tokens->list[i + 3].at + 1 - tokens->list[i].at, "%s %.*s",
                       word, (int)type->size, tokens->text + type->at);
    } else if (statement && glsl_token_is(tokens, end, ";")) {
        take(tokens, i, end, edits);
    }
}

void dialect_expand(GlslSource *source) {
    GlslTokens tokens = glsl_tokens(text_string(&source->text));
    TextEdits edits = {0};
    bool needed = is_needed(source, &tokens);
    for (int i = 0; i < tokens.count; i++) {
        int directive = tokens.list[i].directive;
        if (!directive)
            expand(&tokens, i, &edits);
        else if (!needed && is_macros(source, tokens.list[i].file) &&
                 (!i || tokens.list[i - 1].directive != directive))
            take_directive(&tokens, i, &edits);
    }
    Text text = text_edits_apply(&edits, text_string(&source->text));
    text_free(&source->text);
    source->text = text;
    glsl_tokens_free(&tokens);
}
