/* Uniforms and their values as data. They are collected before there is a program, set in every program that
 * has them, and written by `flatten --json`. */
#pragma once

#include <stdbool.h>

typedef enum UniformType {
    UNIFORM_FLOAT,
    UNIFORM_INT,
    UNIFORM_UINT,
    UNIFORM_VEC3,
    UNIFORM_VEC4,
    /* An array: float name[count]. */
    UNIFORM_FLOATS
} UniformType;

typedef struct Uniform {
    /* The library's file that declares it; NULL for a uniform that the scene declares. */
    const char *file;
    char name[80];
    UniformType type;
    /* The length of the array for UNIFORM_FLOATS, else 1. */
    int count;
    /* `values` holds the components of a scalar or a vector. For UNIFORM_FLOATS `many` holds the array, which
     * the list owns. */
    double values[4];
    double *many;
} Uniform;

/* A zeroed list is empty. */
typedef struct Uniforms {
    Uniform *items;
    int count;
    /* The file that declares the uniforms which are added next. */
    const char *file;
} Uniforms;

void uniforms_free(Uniforms *uniforms);

/* Sets the library's file that declares the uniforms which are added from here on, such as
 * "pass/camera.glsl". They are set only in programs that include this file, and such a program must declare
 * each of them. NULL: the scene declares them. */
void uniforms_declared_in(Uniforms *uniforms, const char *file);

/* These add a uniform to the list and copy the name. */
void uniforms_float(Uniforms *uniforms, const char *name, double value);
void uniforms_int(Uniforms *uniforms, const char *name, int value);
void uniforms_uint(Uniforms *uniforms, const char *name, unsigned value);
void uniforms_vec3(Uniforms *uniforms, const char *name, const double value[3]);
void uniforms_vec4(Uniforms *uniforms, const char *name, const double value[4]);
void uniforms_floats(Uniforms *uniforms, const char *name, const double *values, int count);
