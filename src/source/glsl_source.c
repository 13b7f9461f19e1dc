#include "source/glsl_source.h"

#include "base/lines.h"
#include "base/memory.h"
#include "base/near.h"
#include "source/glsl_blocks.h"
#include "source/glsl_find.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

typedef struct Flattener {
    GlslSource *source;
    SourceStore *store;
    const GlslSlot *slots;
    /* The files of `source`, by number; NULL for what was written here. */
    const SourceFile **files;
    /* How many files are being included, each by the one before, and how many lines included one so far. */
    int depth, includes;
} Flattener;

/* Where an #include stands. */
typedef struct Place {
    const char *path;
    int line;
} Place;

static bool include_file(Flattener *flattener, const Found *found, const Place *place, Error *error);

static bool fail_at(const Place *place, Error *error) {
    return error_prefix(error, "%s:%d: ", place->path, place->line);
}

static int add_file(Flattener *flattener, const char *path, const SourceFile *file) {
    GlslSource *source = flattener->source;
    size_t count = (size_t)source->file_count + 1;
    source->files = memory_grow(source->files, count, sizeof *source->files);
    flattener->files = memory_grow((void *)flattener->files, count, sizeof *flattener->files);
    source->files[count - 1] = memory_string(path);
    flattener->files[count - 1] = file;
    return source->file_count++;
}

static bool fill_slot(Flattener *flattener, const GlslSlot *slot, const Place *place, Error *error) {
    if (slot->text) {
        text_print(&flattener->source->text, "%s\n", slot->text);
        return true;
    }
    bool own = strcmp(slot->name, "scene") == 0 || strcmp(slot->name, "common") == 0;
    Found found = glsl_find_chosen(flattener->store, slot->path, own);
    bool ok = found.path ? include_file(flattener, &found, place, error)
                         : error_set(error, STATUS_SCENE, "%s:%d: no file '%s' for <%s>", place->path,
                                     place->line, slot->path, slot->name);
    free(found.path);
    return ok;
}

static bool include_slot(Flattener *flattener, const char *name, const Place *place, Error *error) {
    if (strcmp(name, "materials") == 0) {
        text_print(&flattener->source->text, "#line 1 %d\n", add_file(flattener, "<materials>", NULL));
        glsl_materials_write(&flattener->source->materials, &flattener->source->text);
        return true;
    }
    for (const GlslSlot *slot = flattener->slots; slot && slot->name; slot++) {
        if (strcmp(slot->name, name) == 0) return fill_slot(flattener, slot, place, error);
    }
    return error_set(error, STATUS_SCENE,
                     "%s:%d: unknown slot <%s> in #include: a file is included in quotation marks, #include "
                     "\"%s\"; < > is for what the program chooses, such as <sky>",
                     place->path, place->line, name, name);
}

/* Asks for the file of the same folder of the library that has a name like it. */
static bool no_file(const char *name, const char *library, const Place *place, Error *error) {
    const char *slash = strrchr(name, '/'), *last = slash ? slash + 1 : name;
    struct dirent **entries = NULL;
    Text folder = {0};
    text_print(&folder, "%s/%.*s", library, (int)(last - name), name);
    int count = scandir(text_string(&folder), &entries, NULL, alphasort);
    Near near = near_to(last, strlen(last));
    for (int i = 0; i < count; i++) {
        if (strstr(entries[i]->d_name, ".glsl")) near_try(&near, entries[i]->d_name);
    }
    error_set(error, STATUS_SCENE, "%s:%d: no file '%s' beside this one or in %s%s%.*s%s%s", place->path,
              place->line, name, library, near.name ? ": did you mean " : "",
              near.name ? (int)(last - name) : 0, name, near.name ? near.name : "", near.name ? "?" : "");
    for (int i = 0; i < count; i++) free(entries[i]);
    free(entries);
    text_free(&folder);
    return false;
}

static bool include_quoted(Flattener *flattener, const Found *includer, const char *name, const Place *place,
                           Error *error) {
    if (!source_folders_check_name(name, error)) return fail_at(place, error);
    Found found = glsl_find_quoted(flattener->store, includer, name);
    bool ok = found.path ? include_file(flattener, &found, place, error)
                         : no_file(name, flattener->store->folder, place, error);
    free(found.path);
    return ok;
}

/* `words` points behind "#include". */
static bool include_line(Flattener *flattener, const Found *includer, const char *words, const Place *place,
                         Error *error) {
    words += strspn(words, " \t");
    const char *end = *words == '"' ? strchr(words + 1, '"') : *words == '<' ? strchr(words + 1, '>') : NULL;
    if (!end || end == words + 1) {
        return error_set(error, STATUS_SCENE, "%s:%d: #include needs \"file.glsl\" or <slot>", place->path,
                         place->line);
    }
    if (++flattener->includes > GLSL_INCLUDES_MOST)
        return error_set(error, STATUS_SCENE, "%s:%d: more than %d #include lines", place->path, place->line,
                         GLSL_INCLUDES_MOST);
    char *name = memory_string_part(words + 1, (size_t)(end - words - 1));
    bool ok = *words == '<' ? include_slot(flattener, name, place, error)
                            : include_quoted(flattener, includer, name, place, error);
    free(name);
    return ok;
}

/* One line of file number `file`. An #include that does not count leaves an empty line. */
static bool flatten_line(Flattener *flattener, const Found *found, const char *line, bool counts,
                         const Place *place, int file, Error *error) {
    Text *text = &flattener->source->text;
    const char *words = glsl_directive(line, "include");
    /* The language's version is the entry file's. */
    if ((file && glsl_directive(line, "version")) || glsl_directive(line, "line")) line = "";
    if (words && counts) {
        if (!include_line(flattener, found, words, place, error)) return false;
        text_print(text, "#line %d %d\n", place->line + 1, file);
        return true;
    }
    text_print(text, "%s\n", words ? "" : line);
    /* #version has to be the first line, so the entry file's first #line follows it. */
    if (strncmp(line, "#version", 8) == 0) text_print(text, "#line %d %d\n", place->line + 1, file);
    return true;
}

static bool flatten_lines(Flattener *flattener, const Found *found, const SourceFile *read, int file,
                          Error *error) {
    GlslBlocks blocks = {0};
    Lines lines = lines_of(text_string(&read->text));
    bool ok = true;
    for (char *line; ok && (line = lines_next(&lines));) {
        Place place = {read->path, lines.number};
        bool counts = glsl_line_counts(&blocks, line);
        ok = flatten_line(flattener, found, line, counts, &place, file, error);
    }
    if (ok && blocks.in_comment)
        ok = error_set(error, STATUS_SCENE, "%s:%d: a comment is not closed", read->path, lines.number);
    lines_free(&lines);
    return ok;
}

/* `place` is NULL for the entry file. */
static bool include_file(Flattener *flattener, const Found *found, const Place *place, Error *error) {
    GlslSource *source = flattener->source;
    const SourceFile *file;
    if (!source_store_read(flattener->store, found->path, &file, error))
        return place ? fail_at(place, error) : false;
    for (int i = 0; i < source->file_count; i++) {
        if (flattener->files[i] == file) return true;
    }
    int number = add_file(flattener, file->path, file);
    Place first = {file->path, 1};
    if (!glsl_materials_add(&source->materials, file->path, &source->text, error))
        return fail_at(place ? place : &first, error);
    if (number || strncmp(text_string(&file->text), "#version", 8) != 0)
        text_print(&source->text, "#line 1 %d\n", number);
    if (flattener->depth >= GLSL_DEPTH_MOST)
        return error_set(error, STATUS_SCENE, "%s: files include each other more than %d deep", file->path,
                         GLSL_DEPTH_MOST);
    flattener->depth++;
    bool ok = flatten_lines(flattener, found, file, number, error);
    flattener->depth--;
    return ok;
}

bool glsl_source_create(GlslSource *source, SourceStore *store, const char *entry, const GlslSlot *slots,
                        Error *error) {
    Flattener flattener = {.source = source, .store = store, .slots = slots};
    *source = (GlslSource){0};
    Found found = glsl_find_chosen(store, entry, !slots);
    if (!found.path) found = (Found){memory_string(entry), true};
    bool ok = include_file(&flattener, &found, NULL, error);
    free(found.path);
    free((void *)flattener.files);
    if (!ok) glsl_source_destroy(source);
    return ok;
}

void glsl_source_destroy(GlslSource *source) {
    for (int i = 0; i < source->file_count; i++) free(source->files[i]);
    free(source->files);
    glsl_materials_free(&source->materials);
    text_free(&source->text);
    *source = (GlslSource){0};
}

const char *glsl_source_file(const GlslSource *source, int file) {
    return file >= 0 && file < source->file_count ? source->files[file] : "";
}

bool glsl_source_includes(const GlslSource *source, const char *file) {
    size_t length = strlen(file);
    for (int i = 0; i < source->file_count; i++) {
        size_t size = strlen(source->files[i]);
        if (size >= length && strcmp(source->files[i] + size - length, file) == 0) return true;
    }
    return false;
}

bool glsl_source_is_own(const GlslSource *source, int file, const char *library) {
    size_t length = strlen(library);
    if (file < 0 || file >= source->file_count) return false;
    return strncmp(source->files[file], library, length) != 0 || source->files[file][length] != '/';
}
