#include "render/irradiance.h"

#include "gl/texture.h"

#include <math.h>

enum {
    PATCH_COLUMNS = 64,
    PATCH_ROWS_ABOVE = 64,
    PATCH_ROWS_BELOW = 32,
    PATCH_ROWS = PATCH_ROWS_ABOVE + PATCH_ROWS_BELOW,
    TABLE_COLUMNS = 32,
    TABLE_ROWS = 8,
    TABLE_UNIT = 6
};

static const double degree = 3.14159265358979323846 / 180;

static bool create_programs(Irradiance *irradiance, const char *library, const MethodChoice *sky,
                            const Atmosphere *atmosphere, Error *error) {
    static const char *const entries[] = {"pass/fill_radiance.glsl", "pass/fill_irradiance.glsl"};
    Program *const programs[] = {&irradiance->patches, &irradiance->fill};
    GlslSlot slots[SKY_SLOTS + 1] = {{0}};
    SkySlotText text;
    bool ok = true;
    sky_slots(sky, atmosphere, slots, &text);
    for (int i = 0; ok && i < 2; i++) {
        GlslSource source;
        if (!glsl_source_create(&source, library, entries[i], slots, error)) return false;
        ok = program_create(programs[i], irradiance->gl, &source, error);
        glsl_source_destroy(&source);
    }
    return ok;
}

static void create_targets(Irradiance *irradiance) {
    static const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    const GlApi *gl = irradiance->gl;
    GLuint *texture = irradiance->texture;
    for (int i = 0; i < 2; i++) texture[i] = texture_create(gl, PATCH_COLUMNS, PATCH_ROWS, GL_NEAREST, NULL);
    texture[2] = texture_create(gl, TABLE_COLUMNS, TABLE_ROWS, GL_LINEAR, NULL);
    gl->GenFramebuffers(2, irradiance->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, irradiance->framebuffer[0]);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, targets[0], GL_TEXTURE_2D, texture[0], 0);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, targets[1], GL_TEXTURE_2D, texture[1], 0);
    gl->DrawBuffers(2, targets);
    gl->BindFramebuffer(GL_FRAMEBUFFER, irradiance->framebuffer[1]);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, targets[0], GL_TEXTURE_2D, texture[2], 0);
}

bool irradiance_create(Irradiance *irradiance, const Context *context, const char *library,
                       const MethodChoice *sky, const Atmosphere *atmosphere, Error *error) {
    *irradiance = (Irradiance){.gl = &context->gl};
    if (!create_programs(irradiance, library, sky, atmosphere, error)) goto fail;
    create_targets(irradiance);
    if (gl_check(irradiance->gl, "the sky's irradiance", error)) return true;
fail:
    irradiance_destroy(irradiance);
    return false;
}

void irradiance_destroy(Irradiance *irradiance) {
    if (!irradiance->gl) return;
    irradiance->gl->DeleteFramebuffers(2, irradiance->framebuffer);
    irradiance->gl->DeleteTextures(3, irradiance->texture);
    program_destroy(&irradiance->patches);
    program_destroy(&irradiance->fill);
    *irradiance = (Irradiance){0};
}

static void set_level(const Program *program, const char *name, const SkyState *state) {
    double azimuth = state->sun_azimuth_deg * degree, level[3] = {sin(azimuth), 0, cos(azimuth)};
    program_set_vec3(program, name, level);
}

static bool fill(Irradiance *irradiance, Sky *sky, const SkyState *state, Error *error) {
    static const double patch_count[3] = {PATCH_COLUMNS, PATCH_ROWS_ABOVE, PATCH_ROWS_BELOW};
    static const double size[3] = {TABLE_COLUMNS, TABLE_ROWS, 0};
    const GlApi *gl = irradiance->gl;
    if (!sky_use(sky, &irradiance->patches, state, error)) return false;
    program_set_vec3(&irradiance->patches, "patch_count", patch_count);
    program_set_float(&irradiance->patches, "patch_horizon", sky_horizon_sine(&state->atmosphere));
    set_level(&irradiance->patches, "patch_level", state);
    gl->BindFramebuffer(GL_FRAMEBUFFER, irradiance->framebuffer[0]);
    gl->Viewport(0, 0, PATCH_COLUMNS, PATCH_ROWS);
    program_draw(&irradiance->patches, 0, 0, PATCH_COLUMNS, PATCH_ROWS);

    program_use(&irradiance->fill);
    program_set_vec3(&irradiance->fill, "irradiance_size", size);
    program_set_int(&irradiance->fill, "patch_columns", PATCH_COLUMNS);
    program_set_int(&irradiance->fill, "patch_rows", PATCH_ROWS);
    program_set_int(&irradiance->fill, "patch_lights", 0);
    program_set_int(&irradiance->fill, "patch_directions", 1);
    for (unsigned i = 0; i < 2; i++) {
        gl->ActiveTexture(GL_TEXTURE0 + i);
        gl->BindTexture(GL_TEXTURE_2D, irradiance->texture[i]);
    }
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, irradiance->framebuffer[1]);
    gl->Viewport(0, 0, TABLE_COLUMNS, TABLE_ROWS);
    program_draw(&irradiance->fill, 0, 0, TABLE_COLUMNS, TABLE_ROWS);
    irradiance->filled_for = *state;
    irradiance->fills++;
    return gl_check(gl, "filling the sky's irradiance", error);
}

bool irradiance_use(Irradiance *irradiance, Sky *sky, const Program *program, const SkyState *state,
                    Error *error) {
    static const double size[3] = {TABLE_COLUMNS, TABLE_ROWS, 0};
    const GlApi *gl = irradiance->gl;
    bool filled = irradiance->fills && sky_state_serves(&irradiance->filled_for, state);
    if (!filled && !fill(irradiance, sky, state, error)) return false;
    gl->ActiveTexture(GL_TEXTURE0 + TABLE_UNIT);
    gl->BindTexture(GL_TEXTURE_2D, irradiance->texture[2]);
    gl->ActiveTexture(GL_TEXTURE0);
    program_use(program);
    program_set_int(program, "irradiance_table", TABLE_UNIT);
    program_set_vec3(program, "irradiance_size", size);
    set_level(program, "irradiance_level", state);
    return gl_check(gl, "setting up the sky's irradiance", error);
}
