#include "scene/glsl_source.h"

#include "base/file.h"
#include "base/memory.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct Flattener {
    GlslSource *source;
    const char *library;
    const GlslSlot *slots;
} Flattener;

static bool include_file(Flattener *flattener, const char *path, Error *error);

static int list_find(char **items, int count, const char *item) {
    for (int i = 0; i < count; i++) {
        if (strcmp(items[i], item) == 0) return i;
    }
    return -1;
}

static int list_add(char ***items, int *count, const char *item) {
    *items = memory_grow(*items, (size_t)*count + 1, sizeof **items);
    (*items)[*count] = strdup(item);
    return (*count)++;
}

/* folder/name, or NULL if there is no such file; to be freed. */
static char *existing_file(const char *folder, size_t folder_length, const char *name, size_t name_length) {
    Text path = {0};
    if (folder_length) text_print(&path, "%.*s/", (int)folder_length, folder);
    text_print(&path, "%.*s", (int)name_length, name);
    if (access(text_string(&path), F_OK) == 0) return path.data;
    text_free(&path);
    return NULL;
}

static char *find_quoted(const Flattener *flattener, const char *includer, const char *name, size_t length) {
    const char *slash = strrchr(includer, '/');
    size_t folder_length = slash > includer ? (size_t)(slash - includer) : slash != NULL;
    char *path = existing_file(includer, folder_length, name, length);
    return path ? path : existing_file(flattener->library, strlen(flattener->library), name, length);
}

static char *find_chosen(const Flattener *flattener, const char *path, bool own) {
    char *found =
        own ? NULL : existing_file(flattener->library, strlen(flattener->library), path, strlen(path));
    return found ? found : existing_file("", 0, path, strlen(path));
}

/* "matte" for ".../material/matte.glsl", in `name`; false for any other path. */
static bool material_name(const char *path, char *name, size_t size) {
    const char *slash = strrchr(path, '/');
    static const char folder[] = "material";
    size_t length = sizeof folder - 1;
    if (!slash || slash - path < (long)length || strncmp(slash - length, folder, length) != 0) return false;
    const char *before = slash - length;
    if (before != path && before[-1] != '/') return false;
    snprintf(name, size, "%.*s", (int)strcspn(slash + 1, "."), slash + 1);
    return true;
}

static void number_material(GlslSource *source, const char *name) {
    int number = list_add(&source->materials, &source->material_count, name);
    text_print(&source->text, "const int MATERIAL_");
    for (const char *c = name; *c; c++) text_print(&source->text, "%c", toupper((unsigned char)*c));
    text_print(&source->text, " = %d;\n", number);
}

/* One function for all materials: a call of the right one by the material's kind. */
static void generate_dispatch(GlslSource *source, const char *type, const char *verb, const char *parameters,
                              const char *arguments, const char *nothing) {
    Text *text = &source->text;
    text_print(text, "%s material_%s(Material material, vec3 normal, vec3 incoming, %s) {\n", type, verb,
               parameters);
    for (int i = 0; i < source->material_count; i++) {
        if (i + 1 < source->material_count) text_print(text, "    if (material.kind == %d)\n    ", i);
        text_print(text, "    return %s_%s(material, normal, incoming, %s);\n", source->materials[i], verb,
                   arguments);
    }
    if (!source->material_count) text_print(text, "    return %s;\n", nothing);
    text_print(text, "}\n");
}

static bool emits(const GlslSource *source, int material) {
    char function[80];
    snprintf(function, sizeof function, "%s_emitted", source->materials[material]);
    return glsl_source_defines(source, function);
}

bool glsl_source_emits(const GlslSource *source) {
    for (int i = 0; i < source->material_count; i++) {
        if (emits(source, i)) return true;
    }
    return false;
}

/* Only some materials emit, and only they need a function for it. */
static void generate_emitted(GlslSource *source) {
    Text calls = {0};
    for (int i = 0; i < source->material_count; i++) {
        if (emits(source, i))
            text_print(&calls,
                       "    if (material.kind == %d) return %s_emitted(material, normal, incoming);\n", i,
                       source->materials[i]);
    }
    if (calls.size) {
        text_print(&source->text,
                   "vec3 material_emitted(Material material, vec3 normal, vec3 incoming) {\n%s"
                   "    return vec3(0.0);\n}\n",
                   text_string(&calls));
    }
    text_free(&calls);
}

bool glsl_source_throws(const GlslSource *source) {
    for (int i = 0; i < source->material_count; i++) {
        char constant[80];
        int length = snprintf(constant, sizeof constant, "%s_THROWS", source->materials[i]);
        for (int k = 0; k < length && k < (int)sizeof constant; k++)
            constant[k] = (char)toupper((unsigned char)constant[k]);
        if (!glsl_source_declares(source, "bool", constant)) return true;
    }
    return false;
}

/* A material whose directions are not all alike tells itself how much it throws; one without a density, which
 * has one direction alone, throws all. */
static void generate_throws(GlslSource *source) {
    Text *text = &source->text;
    text_print(text, "float material_throws(Material material, Bounce bounce) {\n");
    for (int i = 0; i < source->material_count; i++) {
        char function[80];
        snprintf(function, sizeof function, "%s_throws", source->materials[i]);
        if (glsl_source_defines(source, function))
            text_print(text, "    if (material.kind == %d) return %s(material);\n", i, function);
    }
    text_print(text, "    return bounce.pdf > 0.0 ? 0.0 : 1.0;\n}\n");
}

static void generate_materials(GlslSource *source) {
    int number = list_add(&source->files, &source->file_count, "<materials>");
    text_print(&source->text, "#line 1 %d\n", number);
    generate_dispatch(source, "Bounce", "sample", "vec2 u, vec2 v", "u, v",
                      "Bounce(normal, vec3(0.0), 0.0, false)");
    generate_dispatch(source, "float", "pdf", "vec3 outgoing", "outgoing", "0.0");
    generate_dispatch(source, "vec3", "value", "vec3 outgoing", "outgoing", "vec3(0.0)");
    generate_emitted(source);
    generate_throws(source);
}

static bool include_slot(Flattener *flattener, const char *name, size_t length, const char *path, int line,
                         Error *error) {
    if (length == strlen("materials") && strncmp(name, "materials", length) == 0) {
        generate_materials(flattener->source);
        return true;
    }
    for (const GlslSlot *slot = flattener->slots; slot && slot->name; slot++) {
        if (strlen(slot->name) != length || strncmp(slot->name, name, length) != 0) continue;
        if (slot->text) {
            text_print(&flattener->source->text, "%s\n", slot->text);
            return true;
        }
        char *found = find_chosen(flattener, slot->path, strcmp(slot->name, "scene") == 0);
        if (!found) {
            return error_set(error, STATUS_SCENE, "%s:%d: no file '%s' for <%s>", path, line, slot->path,
                             slot->name);
        }
        bool ok = include_file(flattener, found, error);
        free(found);
        return ok;
    }
    return error_set(error, STATUS_SCENE, "%s:%d: unknown slot <%.*s> in #include", path, line, (int)length,
                     name);
}

/* `name` points behind "#include". */
static bool include_line(Flattener *flattener, const char *name, const char *path, int line, Error *error) {
    name += strspn(name, " \t");
    const char *end = *name == '"' ? strchr(name + 1, '"') : *name == '<' ? strchr(name + 1, '>') : NULL;
    if (!end || end == name + 1) {
        return error_set(error, STATUS_SCENE, "%s:%d: #include needs \"file.glsl\" or <slot>", path, line);
    }
    size_t length = (size_t)(end - name - 1);
    if (*name == '<') return include_slot(flattener, name + 1, length, path, line, error);
    char *found = find_quoted(flattener, path, name + 1, length);
    if (!found) {
        return error_set(error, STATUS_SCENE, "%s:%d: no file '%.*s' beside this one or in %s", path, line,
                         (int)length, name + 1, flattener->library);
    }
    bool ok = include_file(flattener, found, error);
    free(found);
    return ok;
}

bool glsl_ends_in_comment(const char *line, bool inside) {
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

static const char *after_include(const char *line) {
    line += strspn(line, " \t");
    if (*line != '#') return NULL;
    line += 1 + strspn(line + 1, " \t");
    return strncmp(line, "include", 7) == 0 && !isalnum((unsigned char)line[7]) ? line + 7 : NULL;
}

static bool flatten_lines(Flattener *flattener, const char *path, int file, char *content, Error *error) {
    Text *text = &flattener->source->text;
    bool in_comment = false;
    int number = 1;
    for (char *line = content; *line; number++) {
        char *end = line + strcspn(line, "\n");
        bool last = !*end;
        *end = 0;
        const char *name = in_comment ? NULL : after_include(line);
        if (name) {
            if (!include_line(flattener, name, path, number, error)) return false;
            text_print(text, "#line %d %d\n", number + 1, file);
        } else {
            text_append(text, line, strlen(line));
            text_append(text, "\n", 1);
            /* #version has to be the first line, so the entry file's first #line follows it. */
            if (strncmp(line, "#version", 8) == 0) text_print(text, "#line %d %d\n", number + 1, file);
        }
        in_comment = glsl_ends_in_comment(line, in_comment);
        line = last ? end : end + 1;
    }
    if (in_comment) return error_set(error, STATUS_SCENE, "%s:%d: a comment is not closed", path, number - 1);
    return true;
}

static bool include_file(Flattener *flattener, const char *path, Error *error) {
    GlslSource *source = flattener->source;
    if (list_find(source->files, source->file_count, path) >= 0) return true;
    Text content = {0};
    if (!file_read(path, STATUS_SCENE, &content, error)) {
        text_free(&content);
        return false;
    }
    if (content.size && memchr(content.data, 0, content.size)) {
        error_set(error, STATUS_SCENE, "%s:1: not a text file", path);
        text_free(&content);
        return false;
    }
    text_append(&content, "", 0);
    int file = list_add(&source->files, &source->file_count, path);
    char name[64];
    if (material_name(path, name, sizeof name)) number_material(source, name);
    char *start = content.data;
    if (strncmp(start, "\xef\xbb\xbf", 3) == 0) start += 3;
    if (strncmp(start, "#version", 8) != 0) text_print(&source->text, "#line 1 %d\n", file);
    bool ok = flatten_lines(flattener, path, file, start, error);
    text_free(&content);
    return ok;
}

bool glsl_source_create(GlslSource *source, const char *library, const char *entry, const GlslSlot *slots,
                        Error *error) {
    Flattener flattener = {.source = source, .library = library, .slots = slots};
    *source = (GlslSource){0};
    char *found = find_chosen(&flattener, entry, !slots);
    bool ok = include_file(&flattener, found ? found : entry, error);
    free(found);
    if (!ok) glsl_source_destroy(source);
    return ok;
}

void glsl_source_destroy(GlslSource *source) {
    for (int i = 0; i < source->file_count; i++) free(source->files[i]);
    for (int i = 0; i < source->material_count; i++) free(source->materials[i]);
    free(source->files);
    free(source->materials);
    text_free(&source->text);
    *source = (GlslSource){0};
}

char *glsl_source_plain(const GlslSource *source) {
    char *plain = strdup(text_string(&source->text));
    for (char *line = plain; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        if (strncmp(line, "#line ", 6) == 0) memcpy(line, "//", 2);
    }
    return plain;
}

/* The file and line that a line of the text came from, by the last #line before it. */
static bool find_place(const GlslSource *source, int wanted, int *file, int *number) {
    const char *line = text_string(&source->text);
    *file = *number = 0;
    for (int at = 1; *line; at++, line += strcspn(line, "\n"), line += *line == '\n') {
        if (strncmp(line, "#line ", 6) != 0 || sscanf(line, "#line %d %d", number, file) != 2) {
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
        if (!place || !find_place(source, number, &file, &number)) {
            text_print(&rest, "%s%.*s", rest.size ? "\n" : "", (int)(line + length - words), words);
            continue;
        }
        text_print(&explained, "%s%s:%d: %.*s", lines++ ? "\n" : "", source->files[file], number,
                   (int)(line + length - words), words);
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

/* A copy with comments blanked, to be freed. */
static char *without_comments(const char *text) {
    char *copy = strdup(text);
    for (char *c = copy; *c;) {
        if (c[0] == '/' && c[1] == '/') {
            while (*c && *c != '\n') *c++ = ' ';
        } else if (c[0] == '/' && c[1] == '*') {
            while (*c && !(c[0] == '*' && c[1] == '/')) *c++ = ' ';
            if (*c) *c++ = ' ', *c++ = ' ';
        } else {
            c++;
        }
    }
    return copy;
}

/* Behind the parenthesis that closes the one at `open`: a parameter list may hold INOUT(Hit). */
static const char *closing_parenthesis(const char *open) {
    int depth = 0;
    for (; *open; open++) {
        depth += (*open == '(') - (*open == ')');
        if (!depth) return open + 1;
    }
    return open;
}

/* Where the function is named with a parameter list behind: its definitions, or its calls and prototypes. */
static int count_mentions(const GlslSource *source, const char *function, bool definitions) {
    char *text = without_comments(text_string(&source->text));
    size_t length = strlen(function);
    int count = 0;
    for (char *at = text; (at = strstr(at, function)); at += length) {
        bool starts = at == text || (!isalnum((unsigned char)at[-1]) && at[-1] != '_');
        const char *next = at + length + strspn(at + length, " \t\n\r");
        if (!starts || *next != '(') continue;
        const char *close = closing_parenthesis(next);
        close += strspn(close, " \t\n\r");
        count += (*close == '{') == definitions;
    }
    free(text);
    return count;
}

bool glsl_source_defines(const GlslSource *source, const char *function) {
    return count_mentions(source, function, true) > 0;
}

int glsl_source_calls(const GlslSource *source, const char *function) {
    return count_mentions(source, function, false);
}

bool glsl_source_includes(const GlslSource *source, const char *file) {
    size_t length = strlen(file);
    for (int i = 0; i < source->file_count; i++) {
        size_t size = strlen(source->files[i]);
        if (size >= length && strcmp(source->files[i] + size - length, file) == 0) return true;
    }
    return false;
}

static bool is_word(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

/* Whether `type` and nothing but blanks stand before text[at]. An empty type always does. */
static bool follows(const char *text, size_t at, const char *type) {
    size_t length = strlen(type), end = at;
    if (!length) return true;
    while (end > 0 && isspace((unsigned char)text[end - 1])) end--;
    return end < at && end >= length && strncmp(text + end - length, type, length) == 0 &&
           (end == length || !is_word(text[end - length - 1]));
}

static bool has_word(const GlslSource *source, const char *type, const char *name) {
    char *text = without_comments(text_string(&source->text));
    size_t length = strlen(name);
    bool found = false;
    for (const char *at = text; !found && (at = strstr(at, name)); at += length) {
        bool whole = (at == text || !is_word(at[-1])) && !is_word(at[length]);
        found = whole && follows(text, (size_t)(at - text), type);
    }
    free(text);
    return found;
}

bool glsl_source_mentions(const GlslSource *source, const char *name) {
    return has_word(source, "", name);
}

bool glsl_source_declares(const GlslSource *source, const char *type, const char *name) {
    return has_word(source, type, name);
}
