#include "source/glsl_log.h"

#include "base/lines.h"
#include "base/memory.h"
#include "source/glsl_clash.h"
#include "source/glsl_line.h"

#include <stdio.h>
#include <string.h>

char *glsl_source_plain(const GlslSource *source) {
    char *plain = memory_string(text_string(&source->text));
    for (char *line = plain; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        if (strncmp(line, "#line ", 6) == 0) memcpy(line, "//", 2);
    }
    return plain;
}

/* The file and line that a line of the text came from, by the last #line before it. */
bool glsl_source_place(const GlslSource *source, int wanted, int *file, int *number) {
    const char *line = text_string(&source->text);
    *file = *number = 0;
    for (int at = 1; *line; at++, line += strcspn(line, "\n"), line += *line == '\n') {
        if (!glsl_line_read(line, number, file)) {
            ++*number;
        } else {
            --*number;
        }
        if (at == wanted) return *file >= 0 && *file < source->file_count;
    }
    return false;
}

/* Reads "S:L(C): words", "S(L) : words" or "ERROR: S:L: words"; false for a line without a place. */
static bool parse_log_line(const char *line, int *number, const char **words) {
    int used = 0;
    line += strspn(line, " \t");
    if (strncmp(line, "ERROR: ", 7) == 0) line += 7;
    if (sscanf(line, "%*d:%d(%*d)%n", number, &used) != 1 || !used) {
        used = 0;
        if (sscanf(line, "%*d(%d)%n", number, &used) != 1 || !used) {
            used = 0;
            if (sscanf(line, "%*d:%d%n", number, &used) != 1 || !used) return false;
        }
    }
    *words = line + used + strspn(line + used, " :\t");
    return true;
}

/* Says which other file has the name that the line declares. */
static void explain_clash(const GlslSource *source, int text_line, Text *explained) {
    GlslClash clash;
    if (!glsl_clash_find(source, text_line, &clash) || clash.file < 0 || clash.file >= source->file_count)
        return;
    text_print(explained, " (%s:%d has the name %s too: give one of them another name)",
               glsl_source_file(source, clash.file), clash.line, clash.name);
}

void glsl_source_explain(const GlslSource *source, const char *log, Error *error) {
    Text explained = {0}, rest = {0};
    int lines = 0;
    for (const char *line = log; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        int length = (int)strcspn(line, "\n"), file, number;
        const char *words;
        if (!length) continue;
        bool place = parse_log_line(line, &number, &words);
        if (!place) words = line;
        if (strncmp(words, "warning", 7) == 0 || lines >= 8) continue;
        if (strncmp(words, "error: ", 7) == 0) words += 7;
        int text_line = number;
        if (!place || !glsl_source_place(source, text_line, &file, &number)) {
            text_print(&rest, "%s%.*s", rest.size ? "\n" : "", (int)(line + length - words), words);
            continue;
        }
        text_print(&explained, "%s%s:%d: %.*s", lines++ ? "\n" : "", glsl_source_file(source, file), number,
                   (int)(line + length - words), words);
        explain_clash(source, text_line, &explained);
    }
    if (lines) {
        error_set(error, STATUS_SCENE, "%s", text_string(&explained));
    } else {
        error_set(error, STATUS_SCENE, "%s: the driver refuses the shader: %s",
                  source->file_count ? source->files[0] : "shader",
                  rest.size ? text_string(&rest) : "no reason given");
    }
    text_free(&explained);
    text_free(&rest);
}

void glsl_source_warnings(const GlslSource *source, const char *log, Text *warnings) {
    Lines lines = lines_of(log);
    for (const char *line; (line = lines_next(&lines));) {
        int file, number;
        const char *words;
        if (!strstr(line, "nitialized") || !parse_log_line(line, &number, &words)) continue;
        if (strncmp(words, "warning: ", 9) == 0) words += 9;
        if (glsl_source_place(source, number, &file, &number))
            text_print(warnings, "%s:%d: %s\n", glsl_source_file(source, file), number, words);
    }
    lines_free(&lines);
}
