#include "gl/program.h"
#include "source/glsl_log.h"

#include "base/lines.h"
#include "base/memory.h"
#include "base/text.h"
#include "gl/program_table.h"

#include <stdlib.h>
#include <string.h>

/* One triangle that covers the viewport: (-1,-1), (3,-1), (-1,3). */
static const char vertex_source[] =
    "#version 330 core\n"
    "void main() {\n"
    "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "    gl_Position = vec4(corner, 0.0, 1.0);\n"
    "}\n";

/* Reads the log of a shader or a program: the functions for both have the same types. */
static void append_log(PFNGLGETSHADERIVPROC get, PFNGLGETSHADERINFOLOGPROC get_log, GLuint object,
                       Text *log) {
    GLint length = 0;
    get(object, GL_INFO_LOG_LENGTH, &length);
    char *words = memory_get((size_t)length + 1, 1);
    get_log(object, length + 1, NULL, words);
    text_append(log, words, strlen(words));
    free(words);
}

static GLuint compile(const GlApi *gl, GLenum stage, const char *source, Text *log) {
    GLuint shader = gl->CreateShader(stage);
    GLint ok = 0;
    gl->ShaderSource(shader, 1, &source, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    append_log(gl->GetShaderiv, gl->GetShaderInfoLog, shader, log);
    if (ok) return shader;
    gl->DeleteShader(shader);
    return 0;
}

static bool link_program(const GlApi *gl, GLuint program, Text *log) {
    GLint ok = 0;
    gl->LinkProgram(program);
    gl->GetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok) return true;
    append_log(gl->GetProgramiv, gl->GetProgramInfoLog, program, log);
    return false;
}

static void (*watcher)(bool compiling);

void program_set_watch(void (*watch)(bool compiling)) {
    watcher = watch;
}

bool program_create(Program *program, const GlApi *gl, const GlslSource *fragment, Error *error) {
    Text log = {0};
    bool linked = false;
    *program = (Program){.gl = gl};
    GLuint vertex_shader = compile(gl, GL_VERTEX_SHADER, vertex_source, &log);
    char *plain = glsl_source_plain(fragment);
    if (watcher) watcher(true);
    GLuint fragment_shader = compile(gl, GL_FRAGMENT_SHADER, plain, &log);
    free(plain);
    if (vertex_shader && fragment_shader) {
        program->id = gl->CreateProgram();
        gl->AttachShader(program->id, vertex_shader);
        gl->AttachShader(program->id, fragment_shader);
        linked = link_program(gl, program->id, &log);
    }
    if (watcher) watcher(false);
    if (vertex_shader) gl->DeleteShader(vertex_shader);
    if (fragment_shader) gl->DeleteShader(fragment_shader);
    if (linked) {
        gl->UseProgram(program->id);
        glsl_source_warnings(fragment, text_string(&log), &program->warnings);
        program->table = program_table_create(gl, program->id, fragment);
    } else {
        glsl_source_explain(fragment, text_string(&log), error);
        program_destroy(program);
    }
    text_free(&log);
    return linked;
}

void program_destroy(Program *program) {
    if (program->id) program->gl->DeleteProgram(program->id);
    program_table_destroy(program->table);
    text_free(&program->warnings);
    *program = (Program){0};
}

void program_say_warnings(const Program *program, FILE *out) {
    Lines lines = lines_of(text_string(&program->warnings));
    for (const char *line; (line = lines_next(&lines));) fprintf(out, "magichour: warning: %s\n", line);
    lines_free(&lines);
}

void program_use(const Program *program) {
    program->gl->UseProgram(program->id);
}

/* Binds the textures that the program was given to their units. */
static void bind_textures(const Program *program) {
    const GlApi *gl = program->gl;
    for (int i = 0; i < program->table->count; i++) {
        const ProgramUniform *sampler = &program->table->uniforms[i];
        if (sampler->unit < 0 || !sampler->set) continue;
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)sampler->unit);
        gl->BindTexture(GL_TEXTURE_2D, sampler->texture);
    }
    gl->ActiveTexture(GL_TEXTURE0);
}

/* The uniform's location, or -1 if the compiler dropped it; OpenGL ignores a value for -1. */
static GLint locate(const Program *program, const char *name) {
    ProgramUniform *uniform = program_table_find(program->table, name);
    if (!uniform) return -1;
    uniform->set = true;
    return strchr(name, '[') ? program->gl->GetUniformLocation(program->id, name) : uniform->location;
}

void program_set_float(const Program *program, const char *name, double value) {
    program->gl->Uniform1f(locate(program, name), (float)value);
}

void program_set_int(const Program *program, const char *name, int value) {
    program->gl->Uniform1i(locate(program, name), value);
}

void program_set_uint(const Program *program, const char *name, unsigned value) {
    program->gl->Uniform1ui(locate(program, name), value);
}

static void set_floats(const Program *program, const char *name, const double *values, int count) {
    float *floats = memory_get((size_t)count, sizeof *floats);
    for (int i = 0; i < count; i++) floats[i] = (float)values[i];
    program->gl->Uniform1fv(locate(program, name), count, floats);
    free(floats);
}

void program_set_vec3(const Program *program, const char *name, const double value[3]) {
    program->gl->Uniform3f(locate(program, name), (float)value[0], (float)value[1], (float)value[2]);
}

void program_set_vec4(const Program *program, const char *name, const double value[4]) {
    program->gl->Uniform4f(locate(program, name), (float)value[0], (float)value[1], (float)value[2],
                           (float)value[3]);
}

static void set_one(const Program *program, const Uniform *uniform) {
    switch (uniform->type) {
    case UNIFORM_FLOAT:
        program_set_float(program, uniform->name, uniform->values[0]);
        break;
    case UNIFORM_INT:
        program_set_int(program, uniform->name, (int)uniform->values[0]);
        break;
    case UNIFORM_UINT:
        program_set_uint(program, uniform->name, (unsigned)uniform->values[0]);
        break;
    case UNIFORM_VEC3:
        program_set_vec3(program, uniform->name, uniform->values);
        break;
    case UNIFORM_VEC4:
        program_set_vec4(program, uniform->name, uniform->values);
        break;
    case UNIFORM_FLOATS:
        set_floats(program, uniform->name, uniform->many, uniform->count);
        break;
    }
}

void program_set(const Program *program, const Uniforms *uniforms) {
    for (int i = 0; i < uniforms->count; i++) {
        const Uniform *uniform = &uniforms->items[i];
        bool taken = uniform->file ? program_table_includes(program->table, uniform->file)
                                   : program_table_declares(program->table, uniform->name);
        if (taken) set_one(program, uniform);
    }
}

bool program_declares(const Program *program, const char *name) {
    return program_table_declares(program->table, name);
}

void program_set_texture(const Program *program, const char *name, GLuint texture) {
    ProgramUniform *sampler = program_table_find(program->table, name);
    if (!sampler) return;
    sampler->set = true;
    sampler->texture = texture;
}

bool program_check(const Program *program, Error *error) {
    const ProgramTable *table = program->table;
    const char *files = text_string(&table->files) + 1;
    int entry = (int)strcspn(files, "\n");
    if (table->unknown[0]) {
        return error_set(error, STATUS_FAILURE, "%.*s: the host sets the uniform '%s', which is not declared",
                         entry, files, table->unknown);
    }
    for (int i = 0; i < table->count; i++) {
        const ProgramUniform *uniform = &table->uniforms[i];
        if (!uniform->owed || uniform->set) continue;
        return error_set(error, STATUS_FAILURE, "%.*s: the host does not set the uniform '%s'", entry, files,
                         uniform->name);
    }
    return true;
}

void program_draw(const Program *program, int x, int y, int width, int height) {
    bind_textures(program);
    program->gl->Enable(GL_SCISSOR_TEST);
    program->gl->Scissor(x, y, width, height);
    bool first = !program->table->drawn;
    if (first && watcher) watcher(true);
    program->gl->DrawArrays(GL_TRIANGLES, 0, 3);
    if (first && watcher) watcher(false);
    program->table->drawn = true;
    program->gl->Disable(GL_SCISSOR_TEST);
}
