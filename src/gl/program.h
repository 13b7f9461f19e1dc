/* A fragment program drawn on one full-screen triangle, or on points. It knows which uniforms its text
 * declares, gives each of its samplers a texture unit, and binds its own textures whenever it draws, so that
 * programs do not disturb each other. */
#pragma once

#include "gl/context.h"
#include "gl/uniforms.h"
#include "scene/glsl_source.h"

typedef struct Program {
    const GlApi *gl;
    GLuint id;
    /* What it declares and was given so far. */
    struct ProgramTable *table;
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

/* Makes it the program in use. */
void program_use(const Program *program);

/* Set a uniform of the program in use. The text must declare the name; what it declares and the compiler
 * dropped is passed over. program_check() tells of a name that the text does not declare. */
void program_set_float(const Program *program, const char *name, double value);
void program_set_int(const Program *program, const char *name, int value);
void program_set_uint(const Program *program, const char *name, unsigned value);
void program_set_vec3(const Program *program, const char *name, const double value[3]);
void program_set_vec4(const Program *program, const char *name, const double value[4]);

/* Sets the uniforms of a list whose files the program is made of; the others are not its business. It must be
 * in use. */
void program_set(const Program *program, const Uniforms *uniforms);

/* Whether its text declares a uniform of that name. */
bool program_declares(const Program *program, const char *name);

/* Gives a sampler its texture, for as long as it is given no other. The texture must still be there when the
 * program draws. */
void program_set_texture(const Program *program, const char *name, GLuint texture);

/* Whether the host and the text agree: every uniform that was set is declared, and every one that the
 * library's pass/ files declare and the compiler kept was set. STATUS_FAILURE names the first that is not, a
 * mistake in this program and not in a scene. */
MUST_CHECK bool program_check(const Program *program, Error *error);

/* Draws the triangle on the bound framebuffer's pixels [x, x + width) x [y, y + height). */
void program_draw(const Program *program, int x, int y, int width, int height);

/* Draws the first `count` points on the bound framebuffer. */
void program_draw_points(const Program *program, int count);
