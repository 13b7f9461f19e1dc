/* The uniforms that a program declares and the values that were set: the part of gl/program.h that is about
 * names. */
#pragma once

#include "gl/gl_api.h"
#include "source/glsl_source.h"

/* A uniform that the compiler kept. */
typedef struct ProgramUniform {
    char name[80];
    GLint location;
    /* Whether the host must set it: a file of the library's pass/ folder declares it, not the scene. */
    bool owed;
    bool set;
    /* The texture unit and the texture of a sampler; the unit is -1 for all other uniforms. */
    int unit;
    GLuint texture;
} ProgramUniform;

typedef struct ProgramTable {
    ProgramUniform *uniforms;
    int count;
    /* The names that the text declares, and the paths of its files: words with a blank on each side. */
    Text declared, files;
    /* The first name that was set although the text does not declare it; empty if there is none. */
    char unknown[80];
    /* Whether the program has drawn. Drivers put a part of compiling off until then. */
    bool drawn;
} ProgramTable;

/* Lists the uniforms of the linked program `id`, which must be in use, and gives units to its samplers, from
 * 0 in the order of their declarations. */
ProgramTable *program_table_create(const GlApi *gl, GLuint id, const GlslSource *source);
void program_table_destroy(ProgramTable *table);

/* The uniform of that name, or NULL if the compiler dropped it. The name may end in an index such as "[2]". A
 * name that the text does not declare is noted in `unknown`. */
ProgramUniform *program_table_find(ProgramTable *table, const char *name);

/* Whether the library's `file`, such as "pass/camera.glsl", is one of the program's files. */
bool program_table_includes(const ProgramTable *table, const char *file);

/* Whether the text declares that name, even if the compiler dropped it. */
bool program_table_declares(const ProgramTable *table, const char *name);
