#include "sky/irradiance.h"

enum { TABLE_COLUMNS = 32, TABLE_ROWS = 8 };

static bool wants_irradiance(const void *frame) {
    const MethodChoice *light = ((const Frame *)frame)->light;
    return light && light->method->needs_irradiance;
}

static void irradiance_size(const void *frame, int *width, int *height) {
    (void)frame;
    *width = TABLE_COLUMNS;
    *height = TABLE_ROWS;
}

static void irradiance_uniforms(const Resource *irradiance, const void *frame, Uniforms *uniforms) {
    static const double size[3] = {TABLE_COLUMNS, TABLE_ROWS, 0};
    (void)irradiance;
    (void)frame;
    uniforms_declared_in(uniforms, "pass/fill_irradiance.glsl");
    uniforms_vec3(uniforms, "irradiance_size", size);
    uniforms_int(uniforms, "patch_columns", PATCH_COLUMNS);
    uniforms_int(uniforms, "patch_rows", PATCH_ROWS);
    uniforms_declared_in(uniforms, "pass/irradiance.glsl");
    uniforms_vec3(uniforms, "irradiance_size", size);
}

const ResourceKind sky_irradiance = {.name = "the sky's irradiance",
                                     .entry = "pass/fill_irradiance.glsl",
                                     .samplers = {"irradiance_table"},
                                     .filter = GL_LINEAR,
                                     .inputs = {&sky_patches},
                                     .wanted = wants_irradiance,
                                     .size = irradiance_size,
                                     .uniforms = irradiance_uniforms};
