#include "source/glsl_scan.h"

#include "base/memory.h"
#include "source/glsl_blocks.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void blank(char *from, const char *end) {
    for (; from < end; from++) {
        if (*from != '\n') *from = ' ';
    }
}

static void blank_comments(char *text) {
    for (char *c = text; *c;) {
        char *end = c + 1;
        if (c[0] == '/' && c[1] == '/') {
            end = c + strcspn(c, "\n");
            blank(c, end);
        } else if (c[0] == '/' && c[1] == '*') {
            char *close = strstr(c + 2, "*/");
            end = close ? close + 2 : c + strlen(c);
            blank(c, end);
        }
        c = end;
    }
}

static void blank_what_is_left_out(char *text) {
    GlslBlocks blocks = {0};
    for (char *line = text; *line;) {
        char *end = line + strcspn(line, "\n"), kept = *end;
        *end = 0;
        if (!glsl_line_counts(&blocks, line)) blank(line, end);
        *end = kept;
        line = end + (kept != 0);
    }
}

GlslScan glsl_scan(const char *text) {
    GlslScan scan = {memory_string(text)};
    blank_comments(scan.code);
    blank_what_is_left_out(scan.code);
    return scan;
}

void glsl_scan_free(GlslScan *scan) {
    free(scan->code);
    *scan = (GlslScan){0};
}

static bool is_word(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

/* The next place where the whole word stands, from `at` on. */
static const char *find_word(const GlslScan *scan, const char *at, const char *word) {
    size_t length = strlen(word);
    for (; (at = strstr(at, word)); at += length) {
        if ((at == scan->code || !is_word(at[-1])) && !is_word(at[length])) return at;
    }
    return NULL;
}

/* No parameter list has more bytes. Without an end to the search, a text of parentheses that nothing closes
 * would take its length squared. */
enum { MOST_PARAMETERS_BYTES = 4096 };

/* Behind the parenthesis that closes the one at `open`, or NULL: a parameter list may hold INOUT(Hit). */
static const char *closing_parenthesis(const char *open) {
    int depth = 0;
    for (const char *at = open; *at && at < open + MOST_PARAMETERS_BYTES; at++) {
        depth += (*at == '(') - (*at == ')');
        if (!depth) return at + 1;
    }
    return NULL;
}

/* Whether the word at `at` has a parameter list behind it: the list's end, else NULL. */
static const char *after_parameters(const char *at, const char *function) {
    at += strlen(function);
    at += strspn(at, " \t\n\r");
    if (*at != '(') return NULL;
    at = closing_parenthesis(at);
    return at ? at + strspn(at, " \t\n\r") : NULL;
}

/* Where the function is named with a parameter list behind: its definitions, or its calls and prototypes. */
static int count_mentions(const GlslScan *scan, const char *function, bool definitions) {
    int count = 0;
    for (const char *at = scan->code; (at = find_word(scan, at, function)); at++) {
        const char *close = after_parameters(at, function);
        count += close && (*close == '{') == definitions;
    }
    return count;
}

bool glsl_scan_defines(const GlslScan *scan, const char *function) {
    return count_mentions(scan, function, true) > 0;
}

static int line_of(const GlslScan *scan, const char *at) {
    int line = 1;
    for (const char *c = scan->code; c < at; c++) line += *c == '\n';
    return line;
}

int glsl_scan_definition_line(const GlslScan *scan, const char *function) {
    for (const char *at = scan->code; (at = find_word(scan, at, function)); at++) {
        const char *close = after_parameters(at, function);
        if (close && *close == '{') return line_of(scan, at);
    }
    return 0;
}

int glsl_scan_calls(const GlslScan *scan, const char *function) {
    return count_mentions(scan, function, false);
}

/* Whether the word `type` and nothing but blanks stand before `at`. */
static bool follows(const GlslScan *scan, const char *at, const char *type) {
    size_t length = strlen(type);
    const char *end = at;
    while (end > scan->code && isspace((unsigned char)end[-1])) end--;
    return end < at && (size_t)(end - scan->code) >= length && strncmp(end - length, type, length) == 0 &&
           (end - length == scan->code || !is_word(end[-(long)length - 1]));
}

bool glsl_scan_mentions(const GlslScan *scan, const char *name) {
    return find_word(scan, scan->code, name) != NULL;
}

bool glsl_scan_declares(const GlslScan *scan, const char *type, const char *name) {
    for (const char *at = scan->code; (at = find_word(scan, at, name)); at++) {
        if (follows(scan, at, type)) return true;
    }
    return false;
}

int glsl_scan_constant(const GlslScan *scan, const char *name, int *value) {
    for (const char *at = scan->code; (at = find_word(scan, at, name)); at++) {
        int used = 0;
        const char *behind = at + strlen(name);
        if (!follows(scan, at, "int")) continue;
        if (sscanf(behind, " = %9d ; %n", value, &used) != 1 || !used || *value < 0) *value = -1;
        return line_of(scan, at);
    }
    return 0;
}
