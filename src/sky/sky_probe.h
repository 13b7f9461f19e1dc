/* The sky's radiance in listed directions, by a sky method on the GPU. */
#pragma once

#include "sky/sky.h"

typedef struct SkyProbe {
    const GlApi *gl;
    MethodChoice choice;
    Resources tables;
    Program program;
    /* Directions in, radiances out. */
    GLuint texture[2], framebuffer;
} SkyProbe;

/* Whether there is ozone must not change afterwards. */
MUST_CHECK bool sky_probe_create(SkyProbe *probe, const Context *context, const char *library,
                                 const MethodChoice *choice, const Atmosphere *atmosphere, Error *error);
void sky_probe_destroy(SkyProbe *probe);

/* `directions`: 4 floats each, unit vectors (the fourth unused); `radiances`: 4 floats each, RGB and 1. */
MUST_CHECK bool sky_probe_ask(SkyProbe *probe, const SkyState *state, const float *directions, size_t count,
                              float *radiances, Error *error);

/* Seconds of a lookup: the quickest of many draws that look up 65536 of `directions` (or as many as there
 * are) and read nothing back, for about `seconds`, once at least. */
MUST_CHECK bool sky_probe_time(SkyProbe *probe, const SkyState *state, const float *directions, size_t count,
                               double seconds, double *lookup_seconds, Error *error);
