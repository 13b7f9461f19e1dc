/* A program of a fragment shader that is drawn on one full-screen triangle, or on points. It keeps a list of
 * the uniforms that its text declares, gives each of its samplers a texture unit, and binds its own textures
 * whenever it draws, so that programs do not disturb each other. */
#pragma once

#include "gl/context.h"
#include "gl/uniforms.h"
#include "source/glsl_source.h"

#include <stdio.h>

typedef struct Program {
    const GlApi *gl;
    GLuint id;
    /* What the driver says of variables that are read before they are set, a line each with its place; owned.
     */
    Text warnings;
    /* The uniforms that its text declares and those that were set. */
    struct ProgramTable *table;
} Program;

/* Tells who wants to know that a driver begins to compile, and that it is done: neither can be called off.
 * NULL, as at first, is nobody. */
void program_set_watch(void (*watch)(bool compiling));

/* Compiles and links. Errors in the GLSL are STATUS_SCENE with "file:line: the driver's words": the first
 * error, and up to a few more lines after it. */
MUST_CHECK bool program_create(Program *program, const GlApi *gl, const GlslSource *fragment, Error *error);
void program_destroy(Program *program);

/* Prints its warnings. */
void program_say_warnings(const Program *program, FILE *out);

/* Makes this the program in use. */
void program_use(const Program *program);

/* These set a uniform of the program in use. The text must declare the name, or program_check() fails. A
 * uniform that is declared but dropped by the compiler is ignored. */
void program_set_float(const Program *program, const char *name, double value);
void program_set_int(const Program *program, const char *name, int value);
void program_set_uint(const Program *program, const char *name, unsigned value);
void program_set_vec3(const Program *program, const char *name, const double value[3]);
void program_set_vec4(const Program *program, const char *name, const double value[4]);

/* Sets the uniforms of a list whose files are among the program's files, and ignores the others. The program
 * must be in use. */
void program_set(const Program *program, const Uniforms *uniforms);

/* Whether the program's text declares a uniform of that name. */
bool program_declares(const Program *program, const char *name);

/* Sets the texture of a sampler until another one is set. The texture must still exist when the program
 * draws. */
void program_set_texture(const Program *program, const char *name, GLuint texture);

/* Checks that the host and the text agree: the text declares every uniform that was set, and every uniform
 * was set that the library's pass/ files declare and the compiler kept. STATUS_FAILURE names the first
 * uniform for which this is not so; that is a mistake in this program and not in a scene. */
MUST_CHECK bool program_check(const Program *program, Error *error);

/* Draws the triangle on the pixels [x, x + width) x [y, y + height) of the bound framebuffer. */
void program_draw(const Program *program, int x, int y, int width, int height);
