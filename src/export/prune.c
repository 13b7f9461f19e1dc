#include "export/prune.h"

#include "export/users.h"

#include "base/memory.h"
#include "source/glsl_tokens.h"
#include "source/text_edits.h"

#include <stdlib.h>
#include <string.h>

/* What stands outside of functions: a function, a prototype, a structure, a constant. */
typedef struct Piece {
    /* Its tokens are [from, to). */
    int from, to;
    /* The number of the name that it declares, and of the one by which it may be left out; -1 for what has
     * none and stays. */
    int defines, name;
    bool reached, dropped;
} Piece;

typedef struct Pieces {
    const GlslTokens *tokens;
    Piece *list;
    int count;
    /* The names of all pieces. */
    Names names;
    /* By the names' numbers: whether something that is reached mentions it. */
    bool *wanted;
} Pieces;

static const char *const words_before_type[] = {"const",   "highp",     "mediump", "lowp",
                                                "precise", "invariant", NULL};

/* The token that names what is declared from `i` on; -1 where none does. */
static int name_of(const GlslTokens *tokens, int i) {
    while (glsl_token_among(tokens, i, words_before_type)) i++;
    if (glsl_token_is(tokens, i, "precision") || glsl_token_is(tokens, i, "layout")) return -1;
    /* Behind the type, or behind `struct`. */
    int name = i + 1;
    if (glsl_token_is(tokens, name, "[")) name = glsl_token_skip(tokens, name);
    return glsl_token_is_word(tokens, i) && glsl_token_is_word(tokens, name) ? name : -1;
}

/* The token behind the declaration that begins at `i`. */
static int end_of(const GlslTokens *tokens, int i) {
    bool structure = glsl_token_is(tokens, i, "struct");
    while (i < tokens->count && !glsl_token_is(tokens, i, ";")) {
        bool body = glsl_token_is(tokens, i, "{");
        bool bracket = body || glsl_token_is(tokens, i, "(") || glsl_token_is(tokens, i, "[");
        i = bracket ? glsl_token_skip(tokens, i) : i + 1;
        if (body && !structure) return i;
    }
    return i < tokens->count ? i + 1 : i;
}

/* A declaration of several variables stays. */
static bool declares_many(const GlslTokens *tokens, const Piece *piece) {
    return !glsl_token_is(tokens, piece->from, "struct") && glsl_token_is(tokens, piece->to - 1, ";") &&
           glsl_token_comma(tokens, piece->from, piece->to) < piece->to;
}

static void cut(Pieces *pieces, const GlslTokens *tokens) {
    *pieces = (Pieces){.tokens = tokens};
    for (int i = 0; i < tokens->count;) {
        Piece piece = {.from = i, .to = i + 1, .defines = -1, .name = -1};
        if (!tokens->list[i].directive) {
            piece.to = end_of(tokens, i);
            /* Directives behind a body are pieces of their own. */
            while (piece.to > i + 1 && tokens->list[piece.to - 1].directive) piece.to--;
            int name = name_of(tokens, i);
            if (name >= 0 && name < piece.to && !declares_many(tokens, &piece))
                piece.defines = piece.name =
                    names_add(&pieces->names, tokens->text + tokens->list[name].at, tokens->list[name].size);
        }
        pieces->list = memory_grow(pieces->list, (size_t)pieces->count + 1, sizeof *pieces->list);
        pieces->list[pieces->count++] = piece;
        i = piece.to;
    }
    pieces->wanted = memory_get((size_t)pieces->names.count + 1, sizeof *pieces->wanted);
    memset(pieces->wanted, 0, ((size_t)pieces->names.count + 1) * sizeof *pieces->wanted);
}

static void want(Pieces *pieces, const GlslTokens *tokens, int from, int to) {
    for (int i = from; i < to; i++) {
        const GlslToken *token = &tokens->list[i];
        int name =
            token->kind == GLSL_WORD ? names_find(&pieces->names, tokens->text + token->at, token->size) : -1;
        if (name >= 0) pieces->wanted[name] = true;
    }
}

static void want_roots(Pieces *pieces, const char *roots) {
    GlslTokens tokens = glsl_tokens(roots);
    want(pieces, &tokens, 0, tokens.count);
    glsl_tokens_free(&tokens);
}

/* Reaches pieces until no further one is. */
static void reach(Pieces *pieces) {
    for (bool more = true; more;) {
        more = false;
        for (int i = 0; i < pieces->count; i++) {
            Piece *piece = &pieces->list[i];
            if (piece->reached || !(piece->name < 0 || pieces->wanted[piece->name])) continue;
            piece->reached = more = true;
            want(pieces, pieces->tokens, piece->from, piece->to);
        }
    }
}

static bool is_prototype(const Pieces *pieces, const Piece *piece) {
    const GlslTokens *tokens = pieces->tokens;
    return piece->name >= 0 && glsl_token_is(tokens, piece->to - 1, ";") &&
           glsl_token_is(tokens, piece->to - 2, ")") && !glsl_token_is(tokens, piece->from, "const") &&
           !glsl_token_is(tokens, piece->from, "struct");
}

static bool mentions(const Pieces *pieces, const Piece *piece, const char *name) {
    for (int i = piece->from; i < piece->to; i++) {
        if (glsl_token_is(pieces->tokens, i, name)) return true;
    }
    return false;
}

/* Whether a piece that is reached mentions the function before its last definition: then the prototype is
 * needed. */
static bool is_called_early(const Pieces *pieces, int name) {
    bool early = false, mentioned = false;
    for (int i = 0; i < pieces->count; i++) {
        const Piece *piece = &pieces->list[i];
        if (!piece->reached || is_prototype(pieces, piece)) continue;
        if (piece->defines == name)
            early = mentioned;
        else
            mentioned = mentioned || mentions(pieces, piece, pieces->names.list[name]);
    }
    return early;
}

static void drop_prototypes(Pieces *pieces) {
    for (int i = 0; i < pieces->count; i++) {
        Piece *piece = &pieces->list[i];
        if (piece->reached && is_prototype(pieces, piece) && !is_called_early(pieces, piece->name))
            piece->dropped = true;
    }
}

void prune(GlslSource *source, const char *library, const char *roots) {
    GlslTokens tokens = glsl_tokens(text_string(&source->text));
    TextEdits edits = {0};
    Pieces pieces;
    cut(&pieces, &tokens);
    for (int i = 0; i < pieces.count; i++) {
        if (export_is_users(source, tokens.list[pieces.list[i].from].file, library)) pieces.list[i].name = -1;
    }
    want_roots(&pieces, roots);
    reach(&pieces);
    drop_prototypes(&pieces);
    for (int i = 0; i < pieces.count; i++) {
        const Piece *piece = &pieces.list[i];
        const GlslToken *first = &tokens.list[piece->from], *last = &tokens.list[piece->to - 1];
        if (!piece->reached || piece->dropped)
            text_edits_add(&edits, first->at, last->at + last->size - first->at, "%s", "");
    }
    Text text = text_edits_apply(&edits, text_string(&source->text));
    text_free(&source->text);
    source->text = text;
    names_free(&pieces.names);
    free(pieces.list);
    free(pieces.wanted);
    glsl_tokens_free(&tokens);
}
