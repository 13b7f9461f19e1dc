#include "gl/uniforms.h"

#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void uniforms_free(Uniforms *uniforms) {
    for (int i = 0; i < uniforms->count; i++) free(uniforms->items[i].many);
    free(uniforms->items);
    *uniforms = (Uniforms){0};
}

void uniforms_declared_in(Uniforms *uniforms, const char *file) {
    uniforms->file = file;
}

static Uniform *add(Uniforms *uniforms, const char *name, UniformType type, const double *values, int count) {
    uniforms->items = memory_grow(uniforms->items, (size_t)uniforms->count + 1, sizeof *uniforms->items);
    Uniform *uniform = &uniforms->items[uniforms->count++];
    *uniform = (Uniform){.file = uniforms->file, .type = type, .count = 1};
    snprintf(uniform->name, sizeof uniform->name, "%s", name);
    if (count) memcpy(uniform->values, values, (size_t)count * sizeof *values);
    return uniform;
}

void uniforms_float(Uniforms *uniforms, const char *name, double value) {
    add(uniforms, name, UNIFORM_FLOAT, &value, 1);
}

void uniforms_int(Uniforms *uniforms, const char *name, int value) {
    double number = value;
    add(uniforms, name, UNIFORM_INT, &number, 1);
}

void uniforms_uint(Uniforms *uniforms, const char *name, unsigned value) {
    double number = value;
    add(uniforms, name, UNIFORM_UINT, &number, 1);
}

void uniforms_vec3(Uniforms *uniforms, const char *name, const double value[3]) {
    add(uniforms, name, UNIFORM_VEC3, value, 3);
}

void uniforms_vec4(Uniforms *uniforms, const char *name, const double value[4]) {
    add(uniforms, name, UNIFORM_VEC4, value, 4);
}

void uniforms_floats(Uniforms *uniforms, const char *name, const double *values, int count) {
    Uniform *uniform = add(uniforms, name, UNIFORM_FLOATS, NULL, 0);
    uniform->count = count;
    uniform->many = memory_get((size_t)count, sizeof *values);
    memcpy(uniform->many, values, (size_t)count * sizeof *values);
}
