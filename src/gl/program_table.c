#include "gl/program_table.h"

#include "base/memory.h"
#include "source/glsl_uniforms.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* OpenGL's name "gauss_table.node[0]" becomes "gauss_table.node" here, and the text declares it as
 * "gauss_table". */
static size_t length_of_base(const char *name) {
    const char *bracket = strrchr(name, '[');
    return bracket ? (size_t)(bracket - name) : strlen(name);
}

static bool has_word(const Text *words, const char *word, size_t length, bool any_start) {
    const char *list = text_string(words);
    for (const char *at = list; (at = strstr(at, word)); at++) {
        bool starts = at > list && (at[-1] == '\n' || (any_start && at[-1] == '/'));
        if (starts && at[length] == '\n') return true;
    }
    return false;
}

bool program_table_declares(const ProgramTable *table, const char *name) {
    char declared[80];
    snprintf(declared, sizeof declared, "%.*s", (int)strcspn(name, ".["), name);
    return has_word(&table->declared, declared, strlen(declared), false);
}

bool program_table_includes(const ProgramTable *table, const char *file) {
    return has_word(&table->files, file, strlen(file), true);
}

/* Whether a file of the library's pass/ folder declares it. The host sets all uniforms of that folder. */
static bool is_owed(const GlslUniforms *declared, const GlslSource *source, const char *name) {
    char base[80];
    snprintf(base, sizeof base, "%.*s", (int)strcspn(name, ".["), name);
    const GlslUniform *uniform = glsl_uniforms_find(declared, base);
    if (!uniform || uniform->file < 0 || uniform->file >= source->file_count) return false;
    const char *path = glsl_source_file(source, uniform->file), *slash = strrchr(path, '/');
    return slash && slash - path >= 4 && strncmp(slash - 4, "pass", 4) == 0;
}

static bool is_sampler(GLenum type) {
    return type == GL_SAMPLER_2D || type == GL_SAMPLER_3D || type == GL_SAMPLER_CUBE;
}

static void read_uniforms(ProgramTable *table, const GlApi *gl, GLuint id, const GlslUniforms *declared,
                          const GlslSource *source) {
    GLint count = 0;
    gl->GetProgramiv(id, GL_ACTIVE_UNIFORMS, &count);
    table->uniforms = memory_get((size_t)count, sizeof *table->uniforms);
    for (GLint i = 0; i < count; i++) {
        ProgramUniform *uniform = &table->uniforms[table->count];
        GLint size;
        GLenum type;
        gl->GetActiveUniform(id, (GLuint)i, sizeof uniform->name, NULL, &size, &type, uniform->name);
        uniform->name[length_of_base(uniform->name)] = 0;
        uniform->location = gl->GetUniformLocation(id, uniform->name);
        uniform->owed = is_owed(declared, source, uniform->name);
        uniform->unit = is_sampler(type) ? 0 : -1;
        table->count += uniform->location >= 0;
    }
}

/* Units are given in the order of the declarations, which does not depend on the driver. */
static void give_units(ProgramTable *table, const GlApi *gl, const GlslUniforms *declared) {
    int unit = 0;
    for (int i = 0; i < declared->count; i++) {
        for (int k = 0; k < table->count; k++) {
            ProgramUniform *uniform = &table->uniforms[k];
            if (uniform->unit < 0 || strcmp(uniform->name, declared->items[i].name) != 0) continue;
            uniform->unit = unit++;
            gl->Uniform1i(uniform->location, uniform->unit);
        }
    }
}

ProgramTable *program_table_create(const GlApi *gl, GLuint id, const GlslSource *source) {
    ProgramTable *table = memory_get(1, sizeof *table);
    GlslUniforms declared = glsl_uniforms(text_string(&source->text));
    text_print(&table->declared, "\n");
    for (int i = 0; i < declared.count; i++) text_print(&table->declared, "%s\n", declared.items[i].name);
    text_print(&table->files, "\n");
    for (int i = 0; i < source->file_count; i++) text_print(&table->files, "%s\n", source->files[i]);
    read_uniforms(table, gl, id, &declared, source);
    give_units(table, gl, &declared);
    glsl_uniforms_free(&declared);
    return table;
}

void program_table_destroy(ProgramTable *table) {
    if (!table) return;
    text_free(&table->declared);
    text_free(&table->files);
    free(table->uniforms);
    free(table);
}

ProgramUniform *program_table_find(ProgramTable *table, const char *name) {
    size_t length = length_of_base(name);
    for (int i = 0; i < table->count; i++) {
        const char *known = table->uniforms[i].name;
        if (strlen(known) == length && strncmp(known, name, length) == 0) return &table->uniforms[i];
    }
    if (!table->unknown[0] && !program_table_declares(table, name))
        snprintf(table->unknown, sizeof table->unknown, "%s", name);
    return NULL;
}
