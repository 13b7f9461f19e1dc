#include "cmd/library_files.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

static const char ending[] = ".glsl";

/* Whether `word` is one of the words of the list. */
static bool has_word(const char *list, const char *word) {
    size_t length = strlen(word);
    for (const char *at = list; (at = strstr(at, word)); at++) {
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || !at[length])) return true;
    }
    return false;
}

/* Prints the files of one folder (such as "shape"; "" is the library's own) that are compiled, or those that
 * are not. */
static void print_files(const char *library, const char *folder, const char *compiled, bool wanted,
                        Text *out) {
    struct dirent **entries = NULL;
    Text path = {0};
    text_print(&path, "%s/%s%s", library, folder, *folder ? "/" : "");
    size_t start = path.size;
    int count = scandir(text_string(&path), &entries, NULL, alphasort);
    for (int i = 0; i < count; i++) {
        const char *name = entries[i]->d_name, *end = strrchr(name, '.');
        path.size = start;
        text_print(&path, "%s", name);
        if (end && strcmp(end, ending) == 0 && has_word(compiled, text_string(&path)) == wanted)
            text_print(out, "%s%.*s", out->size ? " " : "", (int)(end - name), name);
        free(entries[i]);
    }
    free(entries);
    text_free(&path);
}

static void print_folder(const char *library, const char *folder, const char *compiled, Text *out) {
    Text in = {0}, not_in = {0};
    print_files(library, folder, compiled, true, &in);
    print_files(library, folder, compiled, false, &not_in);
    if (in.size || not_in.size) {
        text_print(out, "  %s: %s%s%s%s\n", *folder ? folder : "glsl", text_string(&in),
                   in.size && not_in.size ? ", " : "", not_in.size ? "not " : "", text_string(&not_in));
    }
    text_free(&in);
    text_free(&not_in);
}

void library_files_print(const char *library, const char *compiled, Text *out) {
    struct dirent **entries = NULL;
    int count = scandir(library, &entries, NULL, alphasort);
    print_folder(library, "", compiled, out);
    for (int i = 0; i < count; i++) {
        if (!strchr(entries[i]->d_name, '.')) print_folder(library, entries[i]->d_name, compiled, out);
        free(entries[i]);
    }
    free(entries);
}
