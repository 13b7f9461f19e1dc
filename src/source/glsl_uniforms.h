/* The uniforms that a flattened text declares. */
#pragma once

#include "source/glsl_source.h"

typedef struct GlslUniform {
    char name[64];
    /* The type as it is written: "vec3", "sampler2D", or a struct's name. */
    char type[32];
    /* The file that declares it, by its number in GlslSource.files, and the line there, from 1. */
    int file, line;
    /* Whether its declaration gives it a value: `uniform float a = 1.0;`. */
    bool has_value;
} GlslUniform;

typedef struct GlslUniforms {
    GlslUniform *items;
    int count;
} GlslUniforms;

/* Lists every declaration outside of comments, `uniform vec3 a, b;` as two. To be freed by
 * glsl_uniforms_free(). */
GlslUniforms glsl_uniforms(const char *text);
void glsl_uniforms_free(GlslUniforms *uniforms);

/* The declaration of that name, or NULL. */
const GlslUniform *glsl_uniforms_find(const GlslUniforms *uniforms, const char *name);
