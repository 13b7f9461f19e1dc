#include "export/structure_choice.h"

#include "source/glsl_scan.h"
#include "source/glsl_tokens.h"

#include <string.h>

static void add_structures(const GlslTokens *tokens, Names *structures) {
    for (int i = 0; i + 2 < tokens->count; i++) {
        const GlslToken *name = &tokens->list[i + 1];
        if (glsl_token_is(tokens, i, "struct") && glsl_token_is_word(tokens, i + 1))
            names_add(structures, tokens->text + name->at, name->size);
    }
}

static bool is_among(const GlslTokens *tokens, int i, const Names *names) {
    const GlslToken *token = &tokens->list[i];
    return i >= 0 && i < tokens->count && names_find(names, tokens->text + token->at, token->size) >= 0;
}

static bool is_same(const GlslTokens *tokens, int i, int k) {
    const GlslToken *word = &tokens->list[k];
    return glsl_token_is_word(tokens, i) && tokens->list[i].size == word->size &&
           strncmp(tokens->text + tokens->list[i].at, tokens->text + word->at, word->size) == 0;
}

/* The structure that the word at `i` is of: the last thing of its name before it, a variable (`call` is
 * false) or a function, is looked at. Gives the token that names the structure; -1 where it is of another
 * type. */
static int structure_of(const GlslTokens *tokens, int i, bool call, const Names *structures) {
    if (call && is_among(tokens, i, structures)) return i;
    for (int k = i - 1; k > 0; k--) {
        bool declares = is_same(tokens, k, i) && glsl_token_is_word(tokens, k - 1) &&
                        !glsl_token_is(tokens, k - 1, "return") && glsl_token_is(tokens, k + 1, "(") == call;
        if (declares) return is_among(tokens, k - 1, structures) ? k - 1 : -1;
    }
    return -1;
}

/* The same for the operand behind the `?` at `i`, which has to be a name or a call alone. */
static int structure_chosen(const GlslTokens *tokens, int i, const Names *structures) {
    bool call = glsl_token_is(tokens, i + 2, "(");
    int end = call ? glsl_token_skip(tokens, i + 2) : i + 2;
    if (!glsl_token_is_word(tokens, i + 1) || !glsl_token_is(tokens, end, ":")) return -1;
    return structure_of(tokens, i + 1, call, structures);
}

bool structure_choice_check(const GlslSource *source, Error *error) {
    GlslScan scan = glsl_scan(text_string(&source->text));
    GlslTokens tokens = glsl_tokens(scan.code);
    Names structures = {0};
    bool ok = true;
    add_structures(&tokens, &structures);
    for (int i = 0; ok && i < tokens.count; i++) {
        int type = glsl_token_is(&tokens, i, "?") ? structure_chosen(&tokens, i, &structures) : -1;
        if (type < 0) continue;
        ok = error_set(error, STATUS_SCENE,
                       "%s:%d: browsers refuse ?: between structures (%.*s): write an `if`",
                       glsl_source_file(source, tokens.list[i].file), glsl_token_line(&tokens, i),
                       (int)tokens.list[type].size, tokens.text + tokens.list[type].at);
    }
    names_free(&structures);
    glsl_tokens_free(&tokens);
    glsl_scan_free(&scan);
    return ok;
}
