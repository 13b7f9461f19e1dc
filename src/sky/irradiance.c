#include "sky/irradiance.h"

#include "gl/texture.h"

enum { TABLE_COLUMNS = 32, TABLE_ROWS = 8, TABLE_UNIT = 6 };

bool irradiance_create(Irradiance *irradiance, const Context *context, const char *library, Error *error) {
    const GlApi *gl = &context->gl;
    GlslSource source;
    const GlslSlot none[1] = {{0}};
    *irradiance = (Irradiance){.gl = gl};
    if (!glsl_source_create(&source, library, "pass/fill_irradiance.glsl", none, error)) return false;
    bool ok = program_create(&irradiance->fill, gl, &source, error);
    glsl_source_destroy(&source);
    if (ok) {
        irradiance->table = texture_create(gl, TABLE_COLUMNS, TABLE_ROWS, GL_LINEAR, NULL);
        gl->GenFramebuffers(1, &irradiance->framebuffer);
        gl->BindFramebuffer(GL_FRAMEBUFFER, irradiance->framebuffer);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, irradiance->table, 0);
        ok = gl_check(gl, "the sky's irradiance", error);
    }
    if (!ok) irradiance_destroy(irradiance);
    return ok;
}

void irradiance_destroy(Irradiance *irradiance) {
    if (!irradiance->gl) return;
    if (irradiance->framebuffer) irradiance->gl->DeleteFramebuffers(1, &irradiance->framebuffer);
    if (irradiance->table) irradiance->gl->DeleteTextures(1, &irradiance->table);
    program_destroy(&irradiance->fill);
    *irradiance = (Irradiance){0};
}

static bool fill(Irradiance *irradiance, SkyPatches *patches, Sky *sky, const SkyState *state, Error *error) {
    static const double size[3] = {TABLE_COLUMNS, TABLE_ROWS, 0};
    const GlApi *gl = irradiance->gl;
    if (!sky_patches_fill(patches, sky, state, error)) return false;
    program_use(&irradiance->fill);
    program_set_vec3(&irradiance->fill, "irradiance_size", size);
    program_set_int(&irradiance->fill, "patch_columns", PATCH_COLUMNS);
    program_set_int(&irradiance->fill, "patch_rows", PATCH_ROWS);
    program_set_int(&irradiance->fill, "patch_lights", 0);
    program_set_int(&irradiance->fill, "patch_directions", 1);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, patches->direction);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, patches->light);
    gl->BindFramebuffer(GL_FRAMEBUFFER, irradiance->framebuffer);
    gl->Viewport(0, 0, TABLE_COLUMNS, TABLE_ROWS);
    program_draw(&irradiance->fill, 0, 0, TABLE_COLUMNS, TABLE_ROWS);
    irradiance->filled_for = *state;
    irradiance->fills++;
    return gl_check(gl, "filling the sky's irradiance", error);
}

void irradiance_bind(const Irradiance *irradiance) {
    if (!irradiance->gl) return;
    irradiance->gl->ActiveTexture(GL_TEXTURE0 + TABLE_UNIT);
    irradiance->gl->BindTexture(GL_TEXTURE_2D, irradiance->table);
    irradiance->gl->ActiveTexture(GL_TEXTURE0);
}

bool irradiance_use(Irradiance *irradiance, SkyPatches *patches, Sky *sky, const Program *program,
                    const SkyState *state, Error *error) {
    static const double size[3] = {TABLE_COLUMNS, TABLE_ROWS, 0};
    const GlApi *gl = irradiance->gl;
    bool filled = irradiance->fills && sky_state_serves(&irradiance->filled_for, state);
    if (!filled && !fill(irradiance, patches, sky, state, error)) return false;
    irradiance_bind(irradiance);
    program_use(program);
    program_set_int(program, "irradiance_table", TABLE_UNIT);
    program_set_vec3(program, "irradiance_size", size);
    program_set_vec3(program, "irradiance_level", state->sun.level);
    return gl_check(gl, "setting up the sky's irradiance", error);
}
