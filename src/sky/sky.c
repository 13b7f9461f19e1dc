#include "sky/sky.h"

#include "choice/bias.h"
#include "gl/texture.h"
#include "sky/gauss_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TABLE_UNIT = 4 }; /* texture units TABLE_UNIT and the next; the film has those before */

bool sky_state_serves(const SkyState *made_for, const SkyState *state) {
    return memcmp(&made_for->atmosphere, &state->atmosphere, sizeof state->atmosphere) == 0 &&
           memcmp(&made_for->sun.elevation_deg, &state->sun.elevation_deg, sizeof(double)) == 0;
}

double sky_horizon_sine(const Atmosphere *atmosphere) {
    double r = atmosphere->planet_radius_m, h = atmosphere->observer_height_m;
    return -sqrt(h * (2 * r + h)) / (r + h);
}

void sky_slots(const MethodChoice *choice, const Atmosphere *atmosphere, GlslSlot *slots, SkySlotText *text) {
    const char *sky = choice->table                ? "pass/sky_table.glsl"
                      : choice->method->integrates ? "pass/sky_direct.glsl"
                                                   : choice->method->file;
    snprintf(text->nodes, sizeof text->nodes, "const int GAUSS_NODES = %d;",
             choice->method->numbers == NUMBERS_NODES ? choice->nodes : 0);
    slots[0] = (GlslSlot){"sky", sky, NULL};
    slots[1] = (GlslSlot){"sums", choice->method->file, NULL};
    slots[2] = (GlslSlot){"absorber",
                          atmosphere->ozone > 0 ? "sky/absorber_ozone.glsl" : "sky/absorber_none.glsl", NULL};
    slots[3] = (GlslSlot){"gauss-nodes", NULL, text->nodes};
}

static bool create_fill(Sky *sky, const char *library, const Atmosphere *atmosphere, Error *error) {
    GlslSlot slots[SKY_SLOTS + 1] = {{0}};
    SkySlotText text;
    GlslSource source;
    sky_slots(&sky->choice, atmosphere, slots, &text);
    if (!glsl_source_create(&source, library, "pass/fill_table.glsl", slots, error)) return false;
    bool ok = program_create(&sky->fill, sky->gl, &source, error);
    glsl_source_destroy(&source);
    if (!ok) return false;
    sky->texture[0] = texture_create(sky->gl, 1, 1, GL_LINEAR, NULL);
    sky->texture[1] = texture_create(sky->gl, 1, 1, GL_LINEAR, NULL);
    sky->gl->GenFramebuffers(1, &sky->framebuffer);
    return gl_check(sky->gl, "the sky's table", error);
}

bool sky_create(Sky *sky, const Context *context, const char *library, const MethodChoice *choice,
                const Atmosphere *atmosphere, Error *error) {
    *sky = (Sky){.gl = &context->gl, .choice = *choice};
    if (!choice->table || create_fill(sky, library, atmosphere, error)) return true;
    sky_destroy(sky);
    return false;
}

void sky_destroy(Sky *sky) {
    if (!sky->gl) return;
    if (sky->framebuffer) sky->gl->DeleteFramebuffers(1, &sky->framebuffer);
    sky->gl->DeleteTextures(2, sky->texture);
    program_destroy(&sky->fill);
    *sky = (Sky){0};
}

static void set_atmosphere(const Program *program, const Atmosphere *a) {
    double rayleigh[3], mie[3], extinction[3], ozone[3];
    for (int c = 0; c < 3; c++) {
        rayleigh[c] = a->rayleigh * a->rayleigh_scatter_per_m[c];
        mie[c] = a->mie * a->mie_scatter_per_m[c];
        extinction[c] = mie[c] * a->mie_extinction_ratio;
        ozone[c] = a->ozone * a->ozone_absorb_per_m[c];
    }
    program_set_float(program, "observer_height_m", a->observer_height_m);
    program_set_float(program, "atmosphere.planet_radius_m", a->planet_radius_m);
    program_set_float(program, "atmosphere.thickness_m", a->top_radius_m - a->planet_radius_m);
    program_set_float(program, "atmosphere.rayleigh_scale_height_m", a->rayleigh_scale_height_m);
    program_set_float(program, "atmosphere.mie_scale_height_m", a->mie_scale_height_m);
    program_set_vec3(program, "atmosphere.rayleigh_scatter_per_m", rayleigh);
    program_set_vec3(program, "atmosphere.mie_scatter_per_m", mie);
    program_set_vec3(program, "atmosphere.mie_extinction_per_m", extinction);
    program_set_float(program, "atmosphere.mie_g", a->mie_g);
    program_set_vec3(program, "atmosphere.ozone_absorb_per_m", ozone);
    program_set_float(program, "atmosphere.ozone_height_m", a->ozone_height_m);
    program_set_float(program, "atmosphere.ozone_half_width_m", a->ozone_half_width_m);
    program_set_vec3(program, "atmosphere.sun_irradiance", a->sun_irradiance);
}

static void set_sun(const Program *program, const SkyState *state) {
    program_set_vec3(program, "sun_direction", state->sun.direction);
    program_set_vec3(program, "sun_level", state->sun.level);
}

static void set_method(const Program *program, const MethodChoice *choice) {
    MethodNumbers numbers = choice->method->numbers;
    if (numbers == NUMBERS_LEVEL) program_set_float(program, "sky_level", choice->level);
    if (numbers == NUMBERS_STEPS) {
        program_set_int(program, "sky_view_samples", choice->steps.view);
        program_set_int(program, "sky_light_samples", choice->steps.light);
    }
    if (numbers != NUMBERS_NODES) return;
    GaussTable table = gauss_table(choice->nodes);
    program_set_floats(program, "gauss_table.node", table.node, GAUSS_MOST);
    program_set_floats(program, "gauss_table.weight", table.weight, GAUSS_MOST);
    program_set_floats(program, "gauss_table.cumulative", table.cumulative, GAUSS_MOST * GAUSS_MOST);
}

/* The sines of elevation between which there is air to look through: the visible horizon's, and 1 or the
 * limb's. */
static void set_table(const Sky *sky, const Program *program, const Atmosphere *a) {
    double r = a->planet_radius_m, h = a->observer_height_m, top = a->top_radius_m - r;
    double size[3] = {sky->columns, sky->rows, 0};
    program_set_vec3(program, "sky_table_size", size);
    program_set_float(program, "sky_horizon", sky_horizon_sine(a));
    program_set_float(program, "sky_limb", h > top ? -sqrt((h - top) * (2 * r + h + top)) / (r + h) : 1);
    program_set_int(program, "sky_table_rayleigh", TABLE_UNIT);
    program_set_int(program, "sky_table_mie", TABLE_UNIT + 1);
}

static void set_all(const Sky *sky, const Program *program, const SkyState *state) {
    program_use(program);
    set_atmosphere(program, &state->atmosphere);
    set_sun(program, state);
    set_method(program, &sky->choice);
    if (sky->choice.table) set_table(sky, program, &state->atmosphere);
}

static bool resize(Sky *sky, const SkyState *state, Error *error) {
    static const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    const GlApi *gl = sky->gl;
    int columns, rows;
    bias_table_size(&sky->choice, state->sun.elevation_deg, &state->atmosphere, &columns, &rows);
    gl->BindFramebuffer(GL_FRAMEBUFFER, sky->framebuffer);
    if (columns == sky->columns && rows == sky->rows) return true;
    sky->columns = columns;
    sky->rows = rows;
    for (int i = 0; i < 2; i++) {
        texture_resize(gl, sky->texture[i], columns, 2 * rows, NULL);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, targets[i], GL_TEXTURE_2D, sky->texture[i], 0);
    }
    gl->DrawBuffers(2, targets);
    return gl_check(gl, "the sky's table", error);
}

static bool fill(Sky *sky, const SkyState *state, Error *error) {
    if (!resize(sky, state, error)) return false;
    set_all(sky, &sky->fill, state);
    sky->gl->Viewport(0, 0, sky->columns, 2 * sky->rows);
    program_draw(&sky->fill, 0, 0, sky->columns, 2 * sky->rows);
    sky->filled_for = *state;
    sky->fills++;
    return gl_check(sky->gl, "filling the sky's table", error);
}

void sky_bind(const Sky *sky) {
    for (unsigned i = 0; sky->choice.table && i < 2; i++) {
        sky->gl->ActiveTexture(GL_TEXTURE0 + TABLE_UNIT + i);
        sky->gl->BindTexture(GL_TEXTURE_2D, sky->texture[i]);
    }
    sky->gl->ActiveTexture(GL_TEXTURE0);
}

bool sky_use(Sky *sky, const Program *program, const SkyState *state, Error *error) {
    bool filled = sky->fills && sky_state_serves(&sky->filled_for, state);
    if (sky->choice.table && !filled && !fill(sky, state, error)) return false;
    sky_bind(sky);
    set_all(sky, program, state);
    return gl_check(sky->gl, "setting up the sky", error);
}
