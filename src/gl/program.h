/* A fragment program drawn on one full-screen triangle. */
#pragma once

#include "gl/context.h"
#include "scene/glsl_source.h"

typedef struct Program {
    const GlApi *gl;
    GLuint id;
} Program;

/* Compiles and links. GLSL errors come back as STATUS_SCENE with "file:line: the driver's words", the first
 * one first and up to a few more lines after it. */
MUST_CHECK bool program_create(Program *program, const GlApi *gl, const GlslSource *fragment, Error *error);
void program_destroy(Program *program);

/* The same for a program that draws points: one for each texel of the samplers `splat_places` (x and y of a
 * pixel; a point outside of the picture is not drawn) and `splat_lights`, in a picture of `splat_size`
 * pixels. The fragment shader takes the light as `flat in vec4 splat_light`, and declares these uniforms too:
 * see glsl/pass/splat.glsl. */
MUST_CHECK bool program_create_points(Program *program, const GlApi *gl, const GlslSource *fragment,
                                      Error *error);

void program_use(const Program *program);

/* Set a uniform of the program in use. A name that the compiler dropped, or that never was, is no error: a
 * pass offers what it has, a shader takes what it needs. */
void program_set_float(const Program *program, const char *name, double value);
void program_set_int(const Program *program, const char *name, int value);
void program_set_uint(const Program *program, const char *name, unsigned value);
void program_set_floats(const Program *program, const char *name, const double *values,
                        int count); /* float name[count] */
void program_set_vec3(const Program *program, const char *name, const double value[3]);
void program_set_vec4(const Program *program, const char *name, const double value[4]);

/* Draws the triangle on the bound framebuffer's pixels [x, x + width) x [y, y + height). */
void program_draw(const Program *program, int x, int y, int width, int height);

/* Draws the first `count` points on the bound framebuffer. */
void program_draw_points(const Program *program, int count);
