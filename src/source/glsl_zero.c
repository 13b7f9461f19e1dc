#include "source/glsl_zero.h"

#include "base/memory.h"
#include "source/glsl_tokens.h"
#include "source/glsl_types.h"
#include "source/text_edits.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The way through the text. Where `#if` and `#else` each open a brace, only one of them counts. */
typedef struct Depth {
    int braces, brackets;
} Depth;

typedef struct Zero {
    GlslTokens tokens;
    GlslTypes types;
    /* Words among the members of structures. */
    Names members;
    TextEdits edits;
    /* Sets arrays outside of functions. */
    Text start;
    Depth depth;
    Depth *conditions;
    int condition_count;
    bool within_macro;
} Zero;

static const char *const precisions[] = {"highp", "mediump", "lowp", NULL};
/* What begins a declaration that has a value or may not have one. */
static const char *const qualifiers[] = {"const",         "uniform",   "in",        "out",    "varying",
                                         "attribute",     "layout",    "flat",      "smooth", "centroid",
                                         "noperspective", "invariant", "precision", NULL};

static size_t behind(const Zero *zero, int i) {
    return zero->tokens.list[i].at + zero->tokens.list[i].size;
}

static int next(const Zero *zero, int i) {
    return glsl_token_next(&zero->tokens, i);
}

static bool is(const Zero *zero, int i, const char *word) {
    return glsl_token_is(&zero->tokens, i, word);
}

/* Writes the loop that sets all elements of array `name`, whose type stands at `type`. */
static void print_loop(const Zero *zero, const char *name, int length, int type, Text *text) {
    char *value = glsl_types_zero(&zero->types, &zero->tokens, type);
    text_print(
        text,
        " for (int shadertoy_i = 0; shadertoy_i < %.*s.length(); shadertoy_i++) %.*s[shadertoy_i] = %s;",
        length, name, length, name, value);
    free(value);
}

/* Sets the array that is declared at `name`: behind its declaration, or at the program's start. */
static void set_array(Zero *zero, int type, int name, Text *after) {
    const GlslToken *token = &zero->tokens.list[name];
    bool global = !zero->depth.braces && !zero->within_macro;
    if (zero->depth.brackets) return;
    print_loop(zero, zero->tokens.text + token->at, (int)token->size, type, global ? &zero->start : after);
}

/* Reads the names of a declaration from `name` on, and returns the token that ends it. */
static int read_names(Zero *zero, int type, bool array_type, int name) {
    const GlslTokens *tokens = &zero->tokens;
    Text after = {0};
    int at = name;
    while (glsl_token_is_word(tokens, at)) {
        int own = at;
        bool array = array_type;
        at = next(zero, at);
        if (is(zero, at, "[")) array = true, at = glsl_token_skip(tokens, at);
        if (is(zero, at, "=")) {
            at = glsl_token_comma(tokens, at, glsl_token_semicolon(tokens, at));
            if (at == tokens->count) at = next(zero, own);
        } else if (!is(zero, at, ",") && !is(zero, at, ";")) {
            break;
        } else if (array) {
            set_array(zero, type, own, &after);
        } else {
            char *value = glsl_types_zero(&zero->types, tokens, type);
            text_edits_add(&zero->edits, behind(zero, own), 0, " = %s", value);
            free(value);
        }
        if (!is(zero, at, ",")) break;
        at = next(zero, at);
    }
    if (after.size && is(zero, at, ";")) text_edits_add(&zero->edits, behind(zero, at), 0, "%s", after.data);
    text_free(&after);
    return at;
}

/* `out` parameters between the parentheses from `open` on are set in the body, whose brace is at `body`. */
static void set_parameters(Zero *zero, int open, int body) {
    const GlslTokens *tokens = &zero->tokens;
    Text words = {0};
    for (int i = open; i < body; i = next(zero, i)) {
        if (!is(zero, i, "out")) continue;
        int type = next(zero, i);
        if (glsl_token_among(tokens, type, precisions)) type = next(zero, type);
        if (!glsl_types_has(&zero->types, tokens, type)) continue;
        int name = next(zero, type);
        bool array = is(zero, name, "[");
        if (array) name = glsl_token_skip(tokens, name);
        if (!glsl_token_is_word(tokens, name)) continue;
        array |= is(zero, next(zero, name), "[");
        const GlslToken *token = &tokens->list[name];
        char *value = glsl_types_zero(&zero->types, tokens, type);
        if (array)
            print_loop(zero, tokens->text + token->at, (int)token->size, type, &words);
        else
            text_print(&words, " %.*s = %s;", (int)token->size, tokens->text + token->at, value);
        free(value);
    }
    if (words.size) text_edits_add(&zero->edits, behind(zero, body), 0, "%s", words.data);
    text_free(&words);
}

/* Writes statements that set the structure's members; false if a member's type is not known. */
static bool set_members(Zero *zero, int open, int close, Text *words) {
    const GlslTokens *tokens = &zero->tokens;
    for (int i = next(zero, open); i < close;) {
        if (glsl_token_among(tokens, i, precisions)) i = next(zero, i);
        int type = i, end = glsl_token_semicolon(tokens, i);
        if (!glsl_types_has(&zero->types, tokens, type) || end > close) return false;
        i = next(zero, i);
        bool array_type = is(zero, i, "[");
        if (array_type) i = glsl_token_skip(tokens, i);
        while (i < end) {
            char name[80];
            const GlslToken *token = &tokens->list[i];
            snprintf(name, sizeof name, "s.%.*s", (int)token->size, tokens->text + token->at);
            i = next(zero, i);
            bool array = array_type || is(zero, i, "[");
            if (is(zero, i, "[")) i = glsl_token_skip(tokens, i);
            char *value = glsl_types_zero(&zero->types, tokens, type);
            if (array)
                print_loop(zero, name, (int)strlen(name), type, words);
            else
                text_print(words, " %s = %s;", name, value);
            free(value);
            i = next(zero, i);
        }
        if (i < end) return false;
        i = next(zero, end);
    }
    return true;
}

/* A structure outside of functions gets a function that gives its zero. `i` is at `struct`. Returns the next
 * token. */
static int read_structure(Zero *zero, int i) {
    const GlslTokens *tokens = &zero->tokens;
    int name = next(zero, i), open = glsl_token_is_word(tokens, name) ? next(zero, name) : name;
    if (!is(zero, open, "{")) return open;
    int behind_close = glsl_token_skip(tokens, open), end = glsl_token_semicolon(tokens, behind_close);
    Text words = {0};
    bool whole = open > name && !zero->depth.braces && end < tokens->count &&
                 set_members(zero, open, behind_close - 1, &words);
    if (whole) {
        int length = (int)tokens->list[name].size;
        const char *word = tokens->text + tokens->list[name].at;
        text_edits_add(&zero->edits, behind(zero, end), 0,
                       " %.*s shadertoy_zero_%.*s() { %.*s s;%s return s; }", length, word, length, word,
                       length, word, text_string(&words));
        glsl_types_add(&zero->types, tokens, name, true);
    }
    text_free(&words);
    return end < tokens->count ? end : behind_close;
}

/* A declaration or a function that begins with the type at `i`. Returns the next token. */
static int read_typed(Zero *zero, int i) {
    const GlslTokens *tokens = &zero->tokens;
    int name = next(zero, i);
    bool array_type = is(zero, name, "[");
    if (array_type) name = glsl_token_skip(tokens, name);
    if (!glsl_token_is_word(tokens, name)) return next(zero, i);
    int open = next(zero, name);
    if (!is(zero, open, "(")) return read_names(zero, i, array_type, name);
    int body = glsl_token_skip(tokens, open);
    if (is(zero, body, "{")) set_parameters(zero, open, body);
    return body;
}

static void count_brackets(Zero *zero, int i) {
    zero->depth.braces += is(zero, i, "{") - is(zero, i, "}");
    zero->depth.brackets += is(zero, i, "(") - is(zero, i, ")");
}

/* One step through code or through a macro. Returns the next token. */
static int read_code(Zero *zero, int i) {
    const GlslTokens *tokens = &zero->tokens;
    if (is(zero, i, "struct")) return read_structure(zero, i);
    if (glsl_token_among(tokens, i, qualifiers)) {
        int end = glsl_token_semicolon(tokens, i);
        return end < tokens->count ? end : next(zero, i);
    }
    if (is(zero, i, "void") || glsl_types_has(&zero->types, tokens, i)) return read_typed(zero, i);
    count_brackets(zero, i);
    return next(zero, i);
}

static bool is_member(const Zero *zero, int i) {
    const GlslToken *token = &zero->tokens.list[i];
    return names_find(&zero->members, zero->tokens.text + token->at, token->size) >= 0;
}

/* `#define NAME TYPE` makes a type. Declarations in other macros are set as in a function. `i` is at
 * `define`. */
static void read_macro(Zero *zero, int i) {
    const GlslTokens *tokens = &zero->tokens;
    int name = next(zero, i), body = name < tokens->count ? next(zero, name) : name;
    Depth outside = zero->depth;
    if (body == tokens->count || is_member(zero, name)) return;
    bool takes = is(zero, body, "(") && tokens->list[body].at == behind(zero, name);
    if (takes) body = glsl_token_skip(tokens, body);
    if (body == tokens->count) return;
    if (!takes && next(zero, body) == tokens->count && glsl_types_has(&zero->types, tokens, body)) {
        glsl_types_add(&zero->types, tokens, name, false);
        return;
    }
    zero->within_macro = true;
    zero->depth = (Depth){0};
    for (i = body; i < tokens->count;) i = read_code(zero, i);
    zero->within_macro = false;
    zero->depth = outside;
}

/* Only one side of a condition counts. */
static void read_condition(Zero *zero, int i) {
    static const char *const opening[] = {"if", "ifdef", "ifndef", NULL}, *const other[] = {"else", "elif",
                                                                                            NULL};
    if (glsl_token_among(&zero->tokens, i, opening)) {
        zero->conditions =
            memory_grow(zero->conditions, (size_t)zero->condition_count + 1, sizeof *zero->conditions);
        zero->conditions[zero->condition_count++] = zero->depth;
    } else if (zero->condition_count && glsl_token_among(&zero->tokens, i, other)) {
        zero->depth = zero->conditions[zero->condition_count - 1];
    } else if (zero->condition_count && is(zero, i, "endif")) {
        zero->condition_count--;
    }
}

/* Returns the first token behind the directive at `i`. */
static int read_directive(Zero *zero, int i) {
    int word = next(zero, i), directive = zero->tokens.list[i].directive;
    if (is(zero, word, "define"))
        read_macro(zero, word);
    else
        read_condition(zero, word);
    while (i < zero->tokens.count && zero->tokens.list[i].directive == directive) i++;
    return i;
}

static void read_all(Zero *zero, const GlslSource *source, const char *library) {
    for (int i = 0; i < zero->tokens.count;) {
        const GlslToken *token = &zero->tokens.list[i];
        if (token->directive) {
            i = read_directive(zero, i);
            continue;
        }
        if (!glsl_source_is_own(source, token->file, library)) {
            i++;
            continue;
        }
        int end = read_code(zero, i);
        for (i++; i < end;) i = zero->tokens.list[i].directive ? read_directive(zero, i) : i + 1;
    }
}

/* Arrays outside of functions are set when the program starts. */
static void put_start(Zero *zero, const char *function) {
    for (int i = 0; zero->start.size && i < zero->tokens.count; i++) {
        if (!is(zero, i, function) || !is(zero, i + 1, "(")) continue;
        text_edits_add(&zero->edits, behind(zero, glsl_token_skip(&zero->tokens, i + 1)), 0, "%s",
                       zero->start.data);
        return;
    }
}

void glsl_zero(GlslSource *source, const char *library, const char *function) {
    Zero zero = {.tokens = glsl_tokens(text_string(&source->text))};
    glsl_token_members(&zero.tokens, &zero.members);
    read_all(&zero, source, library);
    put_start(&zero, function);
    Text text = text_edits_apply(&zero.edits, text_string(&source->text));
    glsl_tokens_free(&zero.tokens);
    glsl_types_free(&zero.types);
    names_free(&zero.members);
    text_free(&zero.start);
    free(zero.conditions);
    text_free(&source->text);
    source->text = text;
}
