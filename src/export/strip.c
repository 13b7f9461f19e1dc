#include "export/strip.h"

#include "export/users.h"

#include "base/lines.h"
#include "source/glsl_line.h"

#include <ctype.h>
#include <string.h>

/* The lines and the bytes of the comments of the library that stay. */
static const struct {
    int lines;
    size_t bytes;
    bool members;
} limits[] = {[STRIP_ALL] = {0, 0, false}, [STRIP_MOST] = {1, 80, false}, [STRIP_FEW] = {3, 400, true}};

typedef struct Stripper {
    const GlslSource *source;
    const char *glsl_folder;
    Text out;
    /* The file of the line at hand, and of the last line that was written. */
    int file, written;
    /* Whether the line starts within a comment between slash and star. */
    bool in_comment;
    /* A comment that waits for what it explains. */
    Text waiting;
    int waiting_lines;
    bool in_structure, owes_blank;
    StripComments comments;
    /* Whether the entry file's own code has begun: the comment before it is about the file. */
    bool begun;
} Stripper;

static bool is_own(const Stripper *stripper) {
    return export_is_users(stripper->source, stripper->file, stripper->glsl_folder);
}

/* The name that a file is known by: in the library its path there, else its last part. */
static const char *file_name(const Stripper *stripper) {
    const char *path = glsl_source_file(stripper->source, stripper->file), *slash = strrchr(path, '/');
    size_t library = strlen(stripper->glsl_folder);
    if (strncmp(path, stripper->glsl_folder, library) == 0 && path[library] == '/') return path + library + 1;
    return slash ? slash + 1 : path;
}

static void forget(Stripper *stripper) {
    text_free(&stripper->waiting);
    stripper->waiting_lines = 0;
}

static void write_line(Stripper *stripper, const char *line, size_t size) {
    /* The entry file, number 0, is nothing but a list. */
    if (stripper->file != stripper->written && stripper->file > 0) {
        text_print(&stripper->out, "\n// ---- %s\n", file_name(stripper));
        stripper->owes_blank = false;
    }
    if (stripper->owes_blank && stripper->out.size) text_print(&stripper->out, "\n");
    stripper->owes_blank = false;
    stripper->written = stripper->file;
    text_print(&stripper->out, "%s%.*s\n", text_string(&stripper->waiting), (int)size, line);
    forget(stripper);
}

static size_t trimmed(const char *line, size_t size) {
    while (size && isspace((unsigned char)line[size - 1])) size--;
    return size;
}

/* Where the comment of this line begins that goes to its end; the line's size where there is none. Steps over
 * comments between slash and star. */
static size_t comment_start(Stripper *stripper, const char *line) {
    for (size_t i = 0; line[i]; i++) {
        if (stripper->in_comment) {
            stripper->in_comment = !(line[i] == '*' && line[i + 1] == '/');
            i += !stripper->in_comment;
        } else if (line[i] == '/' && line[i + 1] == '/') {
            return i;
        } else if (line[i] == '/' && line[i + 1] == '*') {
            stripper->in_comment = true;
            i++;
        }
    }
    return strlen(line);
}

static void strip_own(Stripper *stripper, const char *line, size_t comment) {
    bool annotation = line[comment] && line[comment + 2] == '@';
    size_t size = trimmed(line, annotation ? comment : strlen(line));
    if (size)
        write_line(stripper, line, size);
    else if (!annotation)
        stripper->owes_blank = true;
}

/* Whether a comment above this line of the library stays. */
static bool explains(const Stripper *stripper, const char *line, size_t size) {
    bool begins = strncmp(line, "const ", 6) == 0 || strncmp(line, "struct ", 7) == 0;
    bool function = !isspace((unsigned char)line[0]) && memchr(line, '(', size) && line[size - 1] == '{';
    bool member = stripper->in_structure && limits[stripper->comments].members;
    return stripper->waiting_lines <= limits[stripper->comments].lines &&
           stripper->waiting.size <= limits[stripper->comments].bytes && (begins || function || member);
}

static void strip_library(Stripper *stripper, const char *line, size_t comment) {
    size_t size = trimmed(line, comment);
    if (!size && line[comment]) {
        text_print(&stripper->waiting, "%s\n", line);
        stripper->waiting_lines++;
        return;
    }
    if (!size) {
        forget(stripper);
        stripper->owes_blank = true;
        return;
    }
    if (!explains(stripper, line, size)) forget(stripper);
    stripper->in_structure = (stripper->in_structure || strncmp(line, "struct ", 7) == 0) && line[0] != '}';
    Text kept = {0};
    text_print(&kept, "%.*s", (int)size, line);
    if (strncmp(line + comment, "//=", 3) == 0) text_print(&kept, "  //%s", line + comment + 3);
    write_line(stripper, text_string(&kept), kept.size);
    text_free(&kept);
}

Text strip(const GlslSource *source, const char *library, StripComments comments) {
    Stripper stripper = {.source = source, .glsl_folder = library, .comments = comments};
    Lines lines = lines_of(text_string(&source->text));
    for (const char *line; (line = lines_next(&lines));) {
        int number;
        if (glsl_line_read(line, &number, &stripper.file)) {
            forget(&stripper);
            stripper.owes_blank = true;
            continue;
        }
        if (strncmp(line, "#version", 8) == 0) continue;
        bool within = stripper.in_comment;
        size_t comment = comment_start(&stripper, line);
        if (stripper.file == 0 && !stripper.begun && line[0] == '/') continue;
        stripper.begun = stripper.begun || stripper.file == 0;
        if (stripper.file == 0 || is_own(&stripper) || within || stripper.in_comment)
            strip_own(&stripper, line, comment);
        else
            strip_library(&stripper, line, comment);
    }
    forget(&stripper);
    lines_free(&lines);
    return stripper.out;
}
