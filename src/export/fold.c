#include "export/fold.h"

#include "export/users.h"
#include "source/glsl_tokens.h"
#include "source/text_edits.h"

#include <ctype.h>
#include <string.h>

typedef struct Folder {
    const GlslSource *source;
    const char *glsl_folder;
    GlslTokens tokens;
    TextEdits edits;
} Folder;

static bool is(const Folder *folder, int i, const char *word) {
    return glsl_token_is(&folder->tokens, i, word);
}

/* Whether the tokens are the two signs of `&&` or `||`. */
static bool are(const Folder *folder, int i, const char *sign) {
    return is(folder, i, sign) && is(folder, i + 1, sign);
}

static bool is_open(const Folder *folder, int i) {
    const GlslToken *token = &folder->tokens.list[i];
    return !token->directive && !export_is_users(folder->source, token->file, folder->glsl_folder);
}

static bool is_value(const Folder *folder, int i) {
    return is(folder, i, "true") || is(folder, i, "false");
}

static size_t start(const Folder *folder, int i) {
    return folder->tokens.list[i].at;
}

static size_t end(const Folder *folder, int i) {
    return folder->tokens.list[i].at + folder->tokens.list[i].size;
}

/* Puts a word in place of the tokens [from, to). */
static bool put(Folder *folder, int from, int to, const char *word) {
    size_t at = start(folder, from);
    text_edits_add(&folder->edits, at, end(folder, to - 1) - at, "%s", word);
    return true;
}

/* Takes the tokens [from, to) away, with the blanks behind them. */
static bool take(Folder *folder, int from, int to) {
    size_t at = start(folder, from);
    text_edits_add(&folder->edits, at, start(folder, to) - at, "%s", "");
    return true;
}

/* Takes [from, to) away with the blanks before them. If nothing is left of its lines, they go, too. */
static void take_lines(Folder *folder, int from, size_t to) {
    size_t at = start(folder, from);
    while (at && strchr(" \t", folder->tokens.text[at - 1])) at--;
    if (at && folder->tokens.text[at - 1] == '\n') at--;
    text_edits_add(&folder->edits, at, to - at, "%s", "");
}

/* The token behind the statement at `i`. */
static int behind_statement(const Folder *folder, int i) {
    const GlslTokens *tokens = &folder->tokens;
    if (i >= tokens->count) return tokens->count;
    if (is(folder, i, "{")) return glsl_token_skip(tokens, i);
    if (is(folder, i, "do")) return glsl_token_semicolon(tokens, behind_statement(folder, i + 1)) + 1;
    if (is(folder, i, "for") || is(folder, i, "while"))
        return behind_statement(folder, glsl_token_skip(tokens, i + 1));
    if (!is(folder, i, "if")) return glsl_token_semicolon(tokens, i) + 1;
    int behind = behind_statement(folder, glsl_token_skip(tokens, i + 1));
    return is(folder, behind, "else") ? behind_statement(folder, behind + 1) : behind;
}

/* The first token from `i` on that ends an operand of the operators in `signs`, outside of brackets. */
static int behind_operand(const Folder *folder, int i, const char *signs) {
    const GlslTokens *tokens = &folder->tokens;
    while (i < tokens->count) {
        char sign = tokens->text[tokens->list[i].at];
        if (tokens->list[i].size == 1 && strchr(signs, sign)) return i;
        i = strchr("([{", sign) ? glsl_token_skip(tokens, i) : i + 1;
    }
    return i;
}

/* Whether an operand of `&&` (`loose`: of `||`, `?`) may begin behind token `i`. */
static bool begins_operand(const Folder *folder, int i, bool loose) {
    static const char *const before[] = {"(", "=", "return", "?", ":", ",", "|", NULL};
    return glsl_token_among(&folder->tokens, i, before) || (!loose && is(folder, i, "&"));
}

/* Leaves of `if (VALUE) A else B` what is taken. */
static bool fold_if(Folder *folder, int i) {
    const GlslTokens *tokens = &folder->tokens;
    int head = i - 2, then = i + 2, behind = behind_statement(folder, then);
    bool has_else = is(folder, behind, "else"), holds = is(folder, i, "true");
    int last = has_else ? behind_statement(folder, behind + 1) : behind;
    int from = holds ? then : behind + 1, to = holds ? behind : last;
    if (!holds && !has_else) {
        /* What stands behind an else needs a statement. */
        if (is(folder, head - 1, "else"))
            put(folder, head, last, "{}");
        else
            take_lines(folder, head, end(folder, last - 1));
        return true;
    }
    if (!is(folder, from, "{") || is(folder, head - 1, "else")) {
        take(folder, head, from);
        if (last > to)
            text_edits_add(&folder->edits, end(folder, to - 1), end(folder, last - 1) - end(folder, to - 1),
                           "%s", "");
        return true;
    }
    /* The block's statements stand where it stood, four blanks to the left. */
    take_lines(folder, head, end(folder, from));
    for (size_t at = end(folder, from); at < start(folder, to - 1); at++) {
        if (strncmp(tokens->text + at, "\n    ", 5) == 0) text_edits_add(&folder->edits, at + 1, 4, "%s", "");
    }
    take_lines(folder, to - 1, end(folder, last - 1));
    return true;
}

static bool fold_choice(Folder *folder, int i) {
    int first = i + 2, depth = 0, colon = first;
    for (; colon < folder->tokens.count; colon++) {
        if (is(folder, colon, "?")) depth++;
        if (is(folder, colon, ":") && depth-- == 0) break;
        if (is(folder, colon, "(")) colon = glsl_token_skip(&folder->tokens, colon) - 1;
    }
    if (is(folder, i, "false")) return take(folder, i, colon + 1);
    int last = behind_operand(folder, colon + 1, ");,:]}");
    take(folder, i, first);
    text_edits_add(&folder->edits, end(folder, colon - 1), end(folder, last - 1) - end(folder, colon - 1),
                   "%s", "");
    return true;
}

/* Simplifies what stands around the value at `i`. */
static bool fold_value(Folder *folder, int i) {
    bool holds = is(folder, i, "true");
    if (is(folder, i - 1, "!")) return put(folder, i - 1, i + 1, holds ? "false" : "true");
    bool alone = is(folder, i - 1, "(") && is(folder, i + 1, ")");
    if (alone && is(folder, i - 2, "if")) return fold_if(folder, i);
    if (alone && !glsl_token_is_word(&folder->tokens, i - 2))
        return put(folder, i - 1, i + 2, holds ? "true" : "false");
    if (are(folder, i + 1, "&") && begins_operand(folder, i - 1, false)) {
        if (holds) return take(folder, i, i + 3);
        return put(folder, i, behind_operand(folder, i + 3, ");,:]}|?"), "false");
    }
    if (are(folder, i + 1, "|") && begins_operand(folder, i - 1, true)) {
        if (!holds) return take(folder, i, i + 3);
        return put(folder, i, behind_operand(folder, i + 3, ");,:]}?"), "true");
    }
    bool ends = behind_operand(folder, i + 1, ");,:]}|?") == i + 1;
    if (i > 2 && ends && ((are(folder, i - 2, "&") && holds) || (are(folder, i - 2, "|") && !holds))) {
        text_edits_add(&folder->edits, end(folder, i - 3), end(folder, i) - end(folder, i - 3), "%s", "");
        return true;
    }
    return is(folder, i + 1, "?") && begins_operand(folder, i - 1, true) && fold_choice(folder, i);
}

/* Whether `bool NAME() { return VALUE; }` or `bool NAME = VALUE;` begins at `i`: gives the value's token. */
static int value_at(const Folder *folder, int i) {
    bool function = is(folder, i + 2, "(") && is(folder, i + 3, ")") && is(folder, i + 4, "{") &&
                    is(folder, i + 5, "return") && is_value(folder, i + 6) && is(folder, i + 7, ";") &&
                    is(folder, i + 8, "}");
    bool constant = is(folder, i - 1, "const") && is(folder, i + 2, "=") && is_value(folder, i + 3) &&
                    is(folder, i + 4, ";");
    if (!is(folder, i, "bool") || !is_open(folder, i)) return 0;
    return function ? i + 6 : constant ? i + 3 : 0;
}

/* Puts the value in place of the name's uses. */
static bool put_value(Folder *folder, int name, int value) {
    const GlslToken *word = &folder->tokens.list[name];
    bool function = is(folder, name + 1, "("), any = false;
    for (int i = 1; i < folder->tokens.count; i++) {
        const GlslToken *token = &folder->tokens.list[i];
        bool same = token->kind == GLSL_WORD && token->size == word->size &&
                    memcmp(folder->tokens.text + token->at, folder->tokens.text + word->at, word->size) == 0;
        if (!same || !is_open(folder, i) ||
            glsl_token_is_word(&folder->tokens, i - 1) != is(folder, i - 1, "return"))
            continue;
        if (is(folder, i - 1, ".") || is(folder, i + 1, "(") != function) continue;
        any = put(folder, i, function ? i + 3 : i + 1, is(folder, value, "true") ? "true" : "false");
    }
    return any;
}

/* Makes one step, and returns false where there is none left. */
static bool step(Folder *folder) {
    for (int i = 1; i + 8 < folder->tokens.count; i++) {
        int value = value_at(folder, i);
        if (value && put_value(folder, i + 1, value)) return true;
    }
    for (int i = 2; i + 4 < folder->tokens.count; i++) {
        if (is_value(folder, i) && is_open(folder, i) && fold_value(folder, i)) return true;
    }
    return false;
}

void fold(GlslSource *source, const char *library) {
    for (bool more = true; more;) {
        Folder folder = {
            .source = source, .glsl_folder = library, .tokens = glsl_tokens(text_string(&source->text))};
        more = step(&folder);
        Text text = text_edits_apply(&folder.edits, text_string(&source->text));
        glsl_tokens_free(&folder.tokens);
        text_free(&source->text);
        source->text = text;
    }
}
