#include "base/file.h"
#include "cmd/cmd.h"
#include "cmd/templates.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef struct Template {
    const char *kind, *text;
} Template;

static const char *template_of(const char *kind) {
    static const Template templates[] = {{"exact", embedded_exact_glsl},
                                         {"marched", embedded_marched_glsl},
                                         {"shadertoy", embedded_shadertoy_glsl}};
    for (size_t i = 0; i < sizeof templates / sizeof *templates; i++)
        if (!kind || strcmp(templates[i].kind, kind) == 0) return templates[i].text;
    return "";
}

static bool ends_with(const char *word, const char *ending) {
    size_t length = strlen(word), least = strlen(ending);
    return length >= least && strcmp(word + length - least, ending) == 0;
}

/* The file's name without folder and ending, with blanks for what joins words. */
static void write_title(const char *path, Text *title) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    for (const char *c = name; *c && strcmp(c, ".glsl") != 0; c++)
        text_append(title, *c == '-' || *c == '_' ? " " : c, 1);
}

/* The words TITLE and FILE stand for the scene's own. */
static void write_scene(const char *text, const char *path, Text *scene) {
    Text title = {0}, file = {0};
    write_title(path, &title);
    text_print_quoted(&file, path);
    while (*text) {
        bool is_title = strncmp(text, "TITLE", 5) == 0, is_file = strncmp(text, "FILE", 4) == 0;
        if (is_title || is_file)
            text_print(scene, "%s", text_string(is_title ? &title : &file));
        else
            text_append(scene, text, 1);
        text += is_title ? 5 : is_file ? 4 : 1;
    }
    text_free(&title);
    text_free(&file);
}

Status cmd_new(const Options *options, Error *error) {
    Text path = {0}, scene = {0}, word = {0};
    const char *given = options->inputs[0];
    text_print(&path, "%s%s", given, ends_with(given, ".glsl") ? "" : ".glsl");
    const char *to = text_string(&path);
    bool ok = access(to, F_OK) != 0 ||
              error_set(error, STATUS_OUTPUT, "%s: there is such a file already; nothing was written", to);
    if (ok) {
        write_scene(template_of(options->kind), to, &scene);
        ok = file_replace(to, scene.data, scene.size, error);
    }
    if (ok) {
        text_print_quoted(&word, to);
        printf("%s: a scene to begin with\nmagichour view %s    # see it change each time you save it\n"
               "magichour render %s -o picture.png\n",
               to, text_string(&word), text_string(&word));
    }
    text_free(&path);
    text_free(&scene);
    text_free(&word);
    return ok ? STATUS_DONE : error->status;
}
