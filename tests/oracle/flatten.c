/* Makes C++ of a case for the oracle: oracle/flatten CASE.glsl CASE.cpp, run from the project's root. The
 * text is flattened as the program does it; compilers' messages keep naming the GLSL files. Writes the files
 * that it read to CASE.cpp.d, for make. */
#include "base/file.h"
#include "source/glsl_source.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* GLSL's `#line 12 3` in C++'s words: the file by its name. */
static void add_lines(Text *cpp, const GlslSource *source) {
    const char *line = text_string(&source->text);
    while (*line) {
        int number, file, length = (int)strcspn(line, "\n");
        if (sscanf(line, "#line %d %d", &number, &file) == 2) {
            text_print(cpp, "#line %d \"%s\"\n", number, source->files[file]);
        } else if (strncmp(line, "#version", 8) != 0) {
            text_print(cpp, "%.*s\n", length, line);
        }
        line += length + (line[length] == '\n');
    }
}

static void make_cpp(Text *cpp, const GlslSource *source, const char *name) {
    text_print(cpp, "#include \"oracle/glsl.hpp\"\n#define float Real\nnamespace {\n");
    add_lines(cpp, source);
    text_print(cpp, "}\n#undef float\nORACLE_EXPORT(%s)\n", name);
}

/* A rule for make; and an empty one for each file, so that a file that goes away is no error. */
static void make_rules(Text *rules, const GlslSource *source, const char *target) {
    text_print(rules, "%s:", target);
    for (int i = 0; i < source->file_count; i++) {
        if (source->files[i][0] != '<') text_print(rules, " %s", source->files[i]);
    }
    text_print(rules, "\n");
    for (int i = 1; i < source->file_count; i++) {
        if (source->files[i][0] != '<') text_print(rules, "%s:\n", source->files[i]);
    }
}

int main(int count, char **arguments) {
    if (count != 3) {
        fprintf(stderr, "usage: flatten CASE.glsl CASE.cpp\n");
        return STATUS_USAGE;
    }
    GlslSource source = {0};
    Text cpp = {0}, rules = {0}, rules_path = {0};
    Error error;
    const char *slash = strrchr(arguments[1], '/');
    char name[64];
    snprintf(name, sizeof name, "%s", slash ? slash + 1 : arguments[1]);
    name[strcspn(name, ".")] = 0;
    SourceStore *store = source_store_create("glsl");
    source_folders_add(&store->folders, ".");
    bool ok = glsl_source_create(&source, store, arguments[1], NULL, &error);
    if (ok) {
        make_cpp(&cpp, &source, name);
        make_rules(&rules, &source, arguments[2]);
        text_print(&rules_path, "%s.d", arguments[2]);
        ok = file_replace(text_string(&rules_path), rules.data, rules.size, &error) &&
             file_replace(arguments[2], cpp.data, cpp.size, &error);
    }
    if (!ok) fprintf(stderr, "%s\n", error.text);
    glsl_source_destroy(&source);
    source_store_release(store);
    text_free(&cpp);
    text_free(&rules);
    text_free(&rules_path);
    return ok ? STATUS_DONE : (int)error.status;
}
