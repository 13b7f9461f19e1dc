#include "export/whole_numbers.h"

#include "export/users.h"

#include <ctype.h>
#include <string.h>

static const char *const float_types[] = {"float", "vec2", "vec3", "vec4", "mat2", "mat3", "mat4", NULL};
static const char *const signs[] = {
    "+", "-", "*", "/", "<", ">", "<=", ">=", "==", "!=", "+=", "-=", "*=", "/=", NULL};
/* Functions whose arguments are floats alone. */
static const char *const float_functions[] = {
    "radians",    "degrees",     "sin",      "cos",  "tan",       "asin", "acos", "atan",
    "sinh",       "cosh",        "tanh",     "pow",  "exp",       "log",  "exp2", "log2",
    "sqrt",       "inversesqrt", "floor",    "ceil", "fract",     "mod",  "mix",  "step",
    "smoothstep", "length",      "distance", "dot",  "normalize", NULL};

/* A text, and whose its files are. */
typedef struct Mender {
    const GlslTokens *tokens;
    const GlslSource *source;
    const char *library;
} Mender;

static bool is(const GlslTokens *tokens, int i, const char *word) {
    return glsl_token_is(tokens, i, word);
}

static bool is_own(const Mender *mender, int i) {
    return export_is_users(mender->source, mender->tokens->list[i].file, mender->library);
}

static bool same(const GlslTokens *tokens, int i, int k) {
    const GlslToken *a = &tokens->list[i], *b = &tokens->list[k];
    return a->size == b->size && memcmp(tokens->text + a->at, tokens->text + b->at, a->size) == 0;
}

/* Whether it is "12", or with a point or an exponent "1.5". */
static bool is_number(const GlslTokens *tokens, int i, bool whole) {
    if (i < 0 || i >= tokens->count || tokens->list[i].kind != GLSL_NUMBER) return false;
    const char *at = tokens->text + tokens->list[i].at;
    size_t size = tokens->list[i].size, digits = 0;
    while (digits < size && isdigit((unsigned char)at[digits])) digits++;
    if (whole) return digits == size && (size == 1 || at[0] != '0');
    return at[1] != 'x' && at[1] != 'X' && digits < size && at[size - 1] != 'u' && at[size - 1] != 'U';
}

/* Whether everything of this name is declared with such a type: functions (`call`), or the user's variables.
 */
static bool is_always(const Mender *mender, int name, bool call, const char *const *types) {
    const GlslTokens *tokens = mender->tokens;
    bool any = false;
    for (int i = 1; i < tokens->count; i++) {
        bool declares = same(tokens, i, name) && glsl_token_is_word(tokens, i - 1) &&
                        !is(tokens, i - 1, "return") && !is(tokens, i - 1, "else") &&
                        is(tokens, i + 1, "(") == call;
        if (!declares || (!call && !is_own(mender, i))) continue;
        if (!glsl_token_among(tokens, i - 1, types)) return false;
        any = true;
    }
    return any;
}

static bool is_float_function(const Mender *mender, int name) {
    const GlslTokens *tokens = mender->tokens;
    return glsl_token_among(tokens, name, float_types) || glsl_token_among(tokens, name, float_functions) ||
           (glsl_token_is_word(tokens, name) && is_always(mender, name, true, float_types));
}

static bool is_swizzle(const GlslTokens *tokens, int i) {
    const GlslToken *token = &tokens->list[i];
    for (size_t k = 0; k < token->size; k++) {
        if (!strchr("xyzwrgba", tokens->text[token->at + k])) return false;
    }
    return token->size <= 4;
}

/* The bracket that the one at `i` closes. */
static int opening(const GlslTokens *tokens, int i) {
    for (int depth = 0; i >= 0; i--) {
        depth += is(tokens, i, ")") - is(tokens, i, "(");
        if (depth == 0) return i;
    }
    return -1;
}

/* Whether the operand that ends with token `i` is a float or a vector of them. */
static bool ends_float(const Mender *mender, int i) {
    const GlslTokens *tokens = mender->tokens;
    static const char *const vectors[] = {"vec2", "vec3", "vec4", NULL};
    if (i < 0) return false;
    if (is(tokens, i, ")")) return is_float_function(mender, opening(tokens, i) - 1);
    if (!glsl_token_is_word(tokens, i)) return is_number(tokens, i, false);
    if (!is(tokens, i - 1, ".")) return is_always(mender, i, false, float_types);
    return is_swizzle(tokens, i) && glsl_token_is_word(tokens, i - 2) && !is(tokens, i - 3, ".") &&
           is_always(mender, i - 2, false, vectors);
}

static bool begins_float(const Mender *mender, int i) {
    const GlslTokens *tokens = mender->tokens;
    if (is(tokens, i, "-")) i++;
    if (!glsl_token_is_word(tokens, i)) return is_number(tokens, i, false);
    if (is(tokens, i + 1, "(")) {
        int behind = glsl_token_skip(tokens, i + 1);
        return !is(tokens, behind, ".") && !is(tokens, behind, "[") && is_float_function(mender, i);
    }
    if (is(tokens, i + 1, "[")) return false;
    return is(tokens, i + 1, ".") ? !is(tokens, i + 3, ".") && ends_float(mender, i + 2)
                                  : ends_float(mender, i);
}

/* Whether parameter `index` of the function that is declared at `name` is a float. */
static bool takes_float(const GlslTokens *tokens, int name, int index) {
    static const char *const before[] = {"const", "in", "highp", "mediump", "lowp", NULL};
    int i = name + 2, end = glsl_token_skip(tokens, name + 1) - 1;
    for (; index > 0 && i < end; index--) i = glsl_token_comma(tokens, i, end) + 1;
    while (glsl_token_among(tokens, i, before)) i++;
    return i < end && is(tokens, i, "float");
}

/* Whether the number [first, last] is an argument for a float. */
static bool is_float_argument(const Mender *mender, int first, int last) {
    const GlslTokens *tokens = mender->tokens;
    bool alone = (is(tokens, first - 1, "(") || is(tokens, first - 1, ",")) &&
                 (is(tokens, last + 1, ")") || is(tokens, last + 1, ","));
    int index = 0, i = first - 1;
    for (int depth = 0; alone && i > 0; i--) {
        if (depth == 0 && is(tokens, i, "(")) break;
        if (is(tokens, i, ";") || is(tokens, i, "{") || is(tokens, i, "}")) return false;
        depth += is(tokens, i, ")") - is(tokens, i, "(");
        index += depth == 0 && is(tokens, i, ",");
    }
    int name = i - 1;
    if (!alone || name < 1 || !glsl_token_is_word(tokens, name)) return false;
    bool any = glsl_token_among(tokens, name, float_functions);
    for (int k = 1; k < tokens->count; k++) {
        bool declares = same(tokens, k, name) && is(tokens, k + 1, "(") &&
                        glsl_token_is_word(tokens, k - 1) && !is(tokens, k - 1, "return") &&
                        !is(tokens, k - 1, "else");
        if (!declares) continue;
        if (!takes_float(tokens, k, index)) return false;
        any = true;
    }
    return any;
}

/* The first token of the statement that has token `i` outside of brackets; -1 where that is in brackets. */
static int statement_start(const GlslTokens *tokens, int i) {
    static const char *const ends[] = {";", "{", "}", NULL};
    for (int depth = 0; i > 0 && !(depth == 0 && glsl_token_among(tokens, i - 1, ends)); i--) {
        depth += is(tokens, i - 1, ")") - is(tokens, i - 1, "(");
        if (depth < 0) return -1;
    }
    return i;
}

/* `float NAME = 1`, or `NAME = 1` for a float. */
static bool is_float_value(const Mender *mender, int first, int last) {
    const GlslTokens *tokens = mender->tokens;
    if (!is(tokens, first - 1, "=") || !(is(tokens, last + 1, ";") || is(tokens, last + 1, ",")))
        return false;
    int start = statement_start(tokens, first);
    if (is(tokens, start, "const")) start++;
    return is(tokens, start, "float") || (is(tokens, last + 1, ";") && ends_float(mender, first - 2));
}

static bool wants_float(const Mender *mender, int i) {
    const GlslTokens *tokens = mender->tokens;
    bool negative = is(tokens, i - 1, "-") && (is(tokens, i - 2, "=") || is(tokens, i - 2, "(") ||
                                               is(tokens, i - 2, ",") || is(tokens, i - 2, "return"));
    int first = negative ? i - 1 : i;
    if (!negative && glsl_token_among(tokens, i - 1, signs) && ends_float(mender, i - 2)) return true;
    if (glsl_token_among(tokens, i + 1, signs) && begins_float(mender, i + 2)) return true;
    return is_float_value(mender, first, i) || is_float_argument(mender, first, i);
}

void whole_numbers_mend(const GlslSource *source, const char *library, const GlslTokens *tokens,
                        TextEdits *edits) {
    const Mender mender = {tokens, source, library};
    for (int i = 1; i < tokens->count; i++) {
        const GlslToken *token = &tokens->list[i];
        if (token->directive || !is_number(tokens, i, true) || !is_own(&mender, i)) continue;
        if (wants_float(&mender, i)) text_edits_add(edits, token->at + token->size, 0, ".0");
    }
}
