#include "source/glsl_missing.h"

#include "base/file.h"
#include "base/lines.h"
#include "source/glsl_scan.h"
#include "source/glsl_tokens.h"

#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What scenes include, in the order in which it is looked through. */
static const char *const folders[] = {"shape", "distance", "material", "color", "math"};

/* Whether the text defines a function of that name, or declares a structure or a constant. */
static bool has(const char *text, const char *name) {
    static const char *const behind[] = {"=", "{", "[", NULL};
    GlslScan scan = glsl_scan(text);
    bool found = glsl_scan_defines(&scan, name);
    GlslTokens tokens = glsl_tokens(scan.code);
    for (int i = 1; i < tokens.count && !found; i++) {
        bool declared = glsl_token_is(&tokens, i - 1, "struct") ||
                        (i > 1 && glsl_token_is(&tokens, i - 2, "const")) ||
                        glsl_token_is(&tokens, i - 1, "define");
        found = declared && glsl_token_is(&tokens, i, name) &&
                (glsl_token_is(&tokens, i - 1, "define") ||
                 glsl_token_among(&tokens, glsl_token_next(&tokens, i), behind));
    }
    glsl_tokens_free(&tokens);
    glsl_scan_free(&scan);
    return found;
}

static bool file_has(const char *path, const char *name) {
    Text text = {0};
    Error ignored;
    bool found = file_read(path, STATUS_SCENE, &text, &ignored) && strstr(text_string(&text), name) &&
                 has(text_string(&text), name);
    text_free(&text);
    return found;
}

static int is_glsl(const struct dirent *entry) {
    size_t length = strlen(entry->d_name);
    return length > 5 && strcmp(entry->d_name + length - 5, ".glsl") == 0;
}

/* Appends the name of the first file that has it: "shape/sphere.glsl". */
static void find(const char *library, const char *folder, const char *name, Text *found) {
    Text path = {0};
    struct dirent **entries = NULL;
    text_print(&path, "%s/%s", library, folder);
    int count = scandir(text_string(&path), &entries, is_glsl, alphasort);
    for (int i = 0; i < count; i++) {
        Text file = {0};
        text_print(&file, "%s/%s", text_string(&path), entries[i]->d_name);
        if (!found->size && file_has(text_string(&file), name))
            text_print(found, "%s/%s", folder, entries[i]->d_name);
        text_free(&file);
        free(entries[i]);
    }
    free(entries);
    text_free(&path);
}

/* The first word between quotation marks of any kind, which is what the line is about. */
static bool quoted(const char *line, char *name, size_t size) {
    const char *open = line + strcspn(line, "'`\"");
    if (!*open) return false;
    size_t length = 0;
    while (isalnum((unsigned char)open[1 + length]) || open[1 + length] == '_') length++;
    if (!length || length >= size || !open[1 + length] || !strchr("'\"", open[1 + length])) return false;
    snprintf(name, size, "%.*s", (int)length, open + 1);
    return true;
}

static void advise(const GlslSource *source, const char *library, const char *line, Text *text) {
    char name[80];
    Text file = {0};
    text_print(text, "%s%s", text->size ? "\n" : "", line);
    if (!quoted(line, name, sizeof name) || has(text_string(&source->text), name)) return;
    for (size_t i = 0; i < sizeof folders / sizeof *folders && !file.size; i++)
        find(library, folders[i], name, &file);
    if (file.size) text_print(text, ": it needs #include \"%s\"", text_string(&file));
    text_free(&file);
}

void glsl_missing_advise(const GlslSource *source, const char *library, Error *error) {
    Text text = {0};
    Lines lines = lines_of(error->text);
    for (const char *line; (line = lines_next(&lines));) advise(source, library, line, &text);
    lines_free(&lines);
    error_set(error, error->status, "%s", text_string(&text));
    text_free(&text);
}
