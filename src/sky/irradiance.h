/* The unblocked sky's irradiance by a surface's normal, tabulated: the control variate of --light control. */
#pragma once

#include "sky/sky_patches.h"

typedef struct Irradiance {
    const GlApi *gl;
    Program fill;
    GLuint table, framebuffer;
    SkyState filled_for;
    int fills;
} Irradiance;

MUST_CHECK bool irradiance_create(Irradiance *irradiance, const Context *context, const char *library,
                                  Error *error);
void irradiance_destroy(Irradiance *irradiance);

/* Fills the table if the sky has changed, and tells `program`, which becomes the program in use. The
 * framebuffer that is bound may change. */
MUST_CHECK bool irradiance_use(Irradiance *irradiance, SkyPatches *patches, Sky *sky, const Program *program,
                               const SkyState *state, Error *error);

/* Puts the table on its texture unit. */
void irradiance_bind(const Irradiance *irradiance);
