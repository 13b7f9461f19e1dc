#include "export/es.h"

#include "export/structure_choice.h"
#include "export/users.h"
#include "export/whole_numbers.h"

#include "source/glsl_blocks.h"
#include "source/glsl_tokens.h"

#include <ctype.h>
#include <string.h>

bool es_mend(GlslSource *source, const char *library, Error *error) {
    TextEdits edits = {0};
    bool own = false;
    for (int i = 0; i < source->file_count; i++) own |= export_is_users(source, i, library);
    if (!own) return true;
    if (!structure_choice_check(source, error)) return false;
    GlslTokens tokens = glsl_tokens(text_string(&source->text));
    whole_numbers_mend(source, library, &tokens, &edits);
    Text text = text_edits_apply(&edits, text_string(&source->text));
    glsl_tokens_free(&tokens);
    text_free(&source->text);
    source->text = text;
    return true;
}

/* In a fragment shader of ES floats have no precision of their own, integers may have 16 bits, and what is
 * read from a texture may have fewer still. */
static const char head[] = "#version 300 es\n"
                           "precision highp float;\n"
                           "precision highp int;\n"
                           "precision highp sampler2D;\n";

static bool is_word(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

/* Whether two tokens need a blank between them, so that they do not become another: `in vec3`, `a - -b`, `a /
 * *`. Mesa pastes the last word of a macro to a word that follows its `)`. */
static bool needs_blank(char before, char after) {
    return ((is_word(before) || before == ')') && is_word(after)) ||
           (strchr("+-", before) && strchr("+-", after)) || (before == '/' && strchr("*/", after));
}

/* Blanks between tokens are left out, but for directives, in which they may mean something. */
static void write_line(const char *line, size_t length, Text *out) {
    while (length && isspace((unsigned char)*line)) line++, length--;
    while (length && isspace((unsigned char)line[length - 1])) length--;
    if (!length) return;
    for (size_t i = 0; i < length; i++) {
        size_t end = i;
        while (*line != '#' && isspace((unsigned char)line[end])) end++;
        if (end > i && needs_blank(line[i - 1], line[end])) text_append(out, " ", 1);
        i = end;
        text_append(out, line + i, 1);
    }
    text_append(out, "\n", 1);
}

/* Each comment becomes a blank; lines stay. */
static void write_code(const char *text, Text *code) {
    for (const char *c = text; *c;) {
        const char *end = glsl_comment_end(c);
        text_append(code, end > c ? " " : c, 1);
        for (const char *in = c; in < end; in++)
            if (*in == '\n') text_append(code, in, 1);
        c = end > c ? end : c + 1;
    }
}

EsReader es_begin(const GlslSource *source) {
    EsReader reader = {0};
    write_code(text_string(&source->text), &reader.code);
    reader.at = text_string(&reader.code);
    return reader;
}

bool es_piece(EsReader *reader, Text *piece) {
    if (!reader->begun) {
        text_append(piece, head, sizeof head - 1);
        return reader->begun = true;
    }
    while (*reader->at) {
        const char *line = reader->at;
        size_t length = strcspn(line, "\n");
        bool cut = glsl_directive(line, "line") != NULL;
        if (!cut && !glsl_directive(line, "version")) write_line(line, length, piece);
        reader->at += length + (line[length] == '\n');
        if (cut && piece->size) return true;
    }
    return piece->size > 0;
}

void es_end(EsReader *reader) {
    text_free(&reader->code);
}

void es_write(const GlslSource *source, Text *out) {
    EsReader reader = es_begin(source);
    for (Text piece = {0}; es_piece(&reader, &piece); text_free(&piece))
        text_append(out, piece.data, piece.size);
    es_end(&reader);
}
