/* Values for uniforms as data: collected before there is a program, given to all programs that have them, and
 * written down by `flatten --json`. */
#pragma once

#include <stdbool.h>

typedef enum UniformType {
    UNIFORM_FLOAT,
    UNIFORM_INT,
    UNIFORM_UINT,
    UNIFORM_VEC3,
    UNIFORM_VEC4,
    /* float name[count] */
    UNIFORM_FLOATS
} UniformType;

typedef struct Uniform {
    /* The library's file that declares it; NULL for a uniform of the scene's own. */
    const char *file;
    char name[80];
    UniformType type;
    /* One for all types but UNIFORM_FLOATS. */
    int count;
    /* The components of a scalar or a vector; UNIFORM_FLOATS has `many`, which the list owns. */
    double values[4];
    double *many;
} Uniform;

/* A zeroed list is empty. */
typedef struct Uniforms {
    Uniform *items;
    int count;
    /* Where the next ones are declared. */
    const char *file;
} Uniforms;

void uniforms_free(Uniforms *uniforms);

/* Says which of the library's files declares the uniforms that are added from here on, such as
 * "pass/camera.glsl". A program that is made without that file is not given them, and a program that is made
 * with it must declare each. NULL: they are the scene's. */
void uniforms_declared_in(Uniforms *uniforms, const char *file);

/* The name is copied. */
void uniforms_float(Uniforms *uniforms, const char *name, double value);
void uniforms_int(Uniforms *uniforms, const char *name, int value);
void uniforms_uint(Uniforms *uniforms, const char *name, unsigned value);
void uniforms_vec3(Uniforms *uniforms, const char *name, const double value[3]);
void uniforms_vec4(Uniforms *uniforms, const char *name, const double value[4]);
void uniforms_floats(Uniforms *uniforms, const char *name, const double *values, int count);
