#include "sky/sky_patches.h"

/* It is filled only as an input of other tables. */
static bool wants_patches(const void *frame) {
    (void)frame;
    return false;
}

static void patches_size(const void *frame, int *width, int *height) {
    (void)frame;
    *width = PATCH_COLUMNS;
    *height = PATCH_ROWS;
}

static void patches_uniforms(const Resource *patches, const void *frame, Uniforms *uniforms) {
    static const double count[3] = {PATCH_COLUMNS, PATCH_ROWS_ABOVE, PATCH_ROWS_BELOW};
    (void)patches;
    uniforms_declared_in(uniforms, "pass/fill_radiance.glsl");
    uniforms_vec3(uniforms, "patch_count", count);
    uniforms_float(uniforms, "patch_horizon", sky_horizon_sine(&((const Frame *)frame)->state.atmosphere));
}

const ResourceKind sky_patches = {.name = "the sky's patches",
                                  .entry = "pass/fill_radiance.glsl",
                                  .samplers = {"patch_lights", "patch_directions"},
                                  .filter = GL_NEAREST,
                                  .wanted = wants_patches,
                                  .size = patches_size,
                                  .key = sky_key,
                                  .uniforms = patches_uniforms};
