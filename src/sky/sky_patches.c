#include "sky/sky_patches.h"

#include "gl/texture.h"

bool sky_patches_create(SkyPatches *patches, const Context *context, const char *library,
                        const MethodChoice *sky, const Atmosphere *atmosphere, Error *error) {
    static const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    const GlApi *gl = &context->gl;
    GlslSlot slots[SKY_SLOTS + 1] = {{0}};
    SkySlotText text;
    GlslSource source;
    *patches = (SkyPatches){.gl = gl};
    sky_slots(sky, atmosphere, slots, &text);
    if (!glsl_source_create(&source, library, "pass/fill_radiance.glsl", slots, error)) return false;
    bool ok = program_create(&patches->program, gl, &source, error);
    glsl_source_destroy(&source);
    if (ok) {
        patches->light = texture_create(gl, PATCH_COLUMNS, PATCH_ROWS, GL_NEAREST, NULL);
        patches->direction = texture_create(gl, PATCH_COLUMNS, PATCH_ROWS, GL_NEAREST, NULL);
        gl->GenFramebuffers(1, &patches->framebuffer);
        gl->BindFramebuffer(GL_FRAMEBUFFER, patches->framebuffer);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, targets[0], GL_TEXTURE_2D, patches->light, 0);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, targets[1], GL_TEXTURE_2D, patches->direction, 0);
        gl->DrawBuffers(2, targets);
        ok = gl_check(gl, "the sky's patches", error);
    }
    if (!ok) sky_patches_destroy(patches);
    return ok;
}

void sky_patches_destroy(SkyPatches *patches) {
    if (!patches->gl) return;
    if (patches->framebuffer) patches->gl->DeleteFramebuffers(1, &patches->framebuffer);
    if (patches->light) patches->gl->DeleteTextures(1, &patches->light);
    if (patches->direction) patches->gl->DeleteTextures(1, &patches->direction);
    program_destroy(&patches->program);
    *patches = (SkyPatches){0};
}

bool sky_patches_fill(SkyPatches *patches, Sky *sky, const SkyState *state, Error *error) {
    static const double count[3] = {PATCH_COLUMNS, PATCH_ROWS_ABOVE, PATCH_ROWS_BELOW};
    if (!sky_use(sky, &patches->program, state, error)) return false;
    program_set_vec3(&patches->program, "patch_count", count);
    program_set_float(&patches->program, "patch_horizon", sky_horizon_sine(&state->atmosphere));
    program_set_vec3(&patches->program, "patch_level", state->sun.level);
    patches->gl->BindFramebuffer(GL_FRAMEBUFFER, patches->framebuffer);
    patches->gl->Viewport(0, 0, PATCH_COLUMNS, PATCH_ROWS);
    program_draw(&patches->program, 0, 0, PATCH_COLUMNS, PATCH_ROWS);
    return gl_check(patches->gl, "the sky's patches", error);
}
