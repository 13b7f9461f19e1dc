/* What a program declares, and what it was given: the part of gl/program.h that is about names. */
#pragma once

#include "gl/gl_api.h"
#include "scene/glsl_source.h"

/* A uniform that the compiler kept. */
typedef struct ProgramUniform {
    char name[80];
    GLint location;
    /* Whether the host has to set it: the library's pass/ files declare it, and not the scene. */
    bool owed;
    bool set;
    /* The texture unit of a sampler, -1 for all others, and the texture that it was given. */
    int unit;
    GLuint texture;
} ProgramUniform;

typedef struct ProgramTable {
    ProgramUniform *uniforms;
    int count;
    /* Words with blanks around each: the names that the text declares, and the paths of its files. */
    Text declared, files;
    /* The first name that was set and is not declared; empty at best. */
    char unknown[80];
} ProgramTable;

/* Reads what the linked program `id` has, and gives units to its samplers, from 0 in the order of their
 * declaration. It must be in use. */
ProgramTable *program_table_create(const GlApi *gl, GLuint id, const GlslSource *source);
void program_table_destroy(ProgramTable *table);

/* The uniform of that name, which may end in an index such as "[2]"; NULL where the compiler dropped it. A
 * name that is not declared is remembered. */
ProgramUniform *program_table_find(ProgramTable *table, const char *name);

/* Whether one of the program's files is the library's `file`, such as "pass/camera.glsl". */
bool program_table_includes(const ProgramTable *table, const char *file);

/* Whether the text declares that name, whatever the compiler did with it. */
bool program_table_declares(const ProgramTable *table, const char *name);
