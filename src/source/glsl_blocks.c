#include "source/glsl_blocks.h"

#include <ctype.h>
#include <string.h>

const char *glsl_directive(const char *line, const char *word) {
    size_t length = strlen(word);
    line += strspn(line, " \t");
    if (*line != '#') return NULL;
    line += 1 + strspn(line + 1, " \t");
    bool is =
        strncmp(line, word, length) == 0 && !isalnum((unsigned char)line[length]) && line[length] != '_';
    return is ? line + length : NULL;
}

static bool ends_in_comment(const char *line, bool inside) {
    for (const char *c = line; *c; c++) {
        if (inside) {
            if (c[0] == '*' && c[1] == '/') inside = false, c++;
        } else if (c[0] == '/' && c[1] == '*') {
            inside = true, c++;
        } else if (c[0] == '/' && c[1] == '/') {
            break;
        }
    }
    return inside;
}

static bool opens_condition(const char *line) {
    return glsl_directive(line, "if") || glsl_directive(line, "ifdef") || glsl_directive(line, "ifndef");
}

/* `#if 0`, perhaps with a comment behind it. */
static bool opens_nothing(const char *line) {
    const char *condition = glsl_directive(line, "if");
    if (!condition) return false;
    condition += strspn(condition, " \t");
    if (*condition != '0') return false;
    condition += 1 + strspn(condition + 1, " \t\r");
    return !*condition || *condition == '/';
}

static void step(GlslBlocks *blocks, const char *line) {
    if (!blocks->left_out) {
        if (opens_nothing(line)) blocks->left_out = 1;
    } else if (opens_condition(line)) {
        blocks->left_out++;
    } else if (glsl_directive(line, "endif")) {
        blocks->left_out--;
    } else if (blocks->left_out == 1 && (glsl_directive(line, "else") || glsl_directive(line, "elif"))) {
        blocks->left_out = 0;
    }
}

bool glsl_line_counts(GlslBlocks *blocks, const char *line) {
    bool counts = !blocks->in_comment && !blocks->left_out;
    if (!blocks->in_comment) step(blocks, line);
    blocks->in_comment = ends_in_comment(line, blocks->in_comment);
    return counts;
}
