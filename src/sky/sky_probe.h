/* The sky's radiance in a list of directions, computed by a sky method on the GPU. */
#pragma once

#include "sky/sky.h"
#include "sky/sky_orders_plan.h"

typedef struct SkyProbe {
    const GlApi *gl;
    MethodChoice choice;
    /* How the further orders are computed. The default may be changed between calls. */
    MethodChoice further;
    /* Asked while the tables are filled, several times a second, for the share of them that is ready; NULL if
     * nobody waits. If it stops that, the call fails with STATUS_INTERRUPTED. */
    const SkyWatch *watch;
    Resources tables;
    Program program;
    /* The textures of the directions and of the radiances. */
    GLuint texture[2], framebuffer;
} SkyProbe;

/* Whether the atmosphere has ozone, and its spectrum, must not change afterwards. */
MUST_CHECK bool sky_probe_create(SkyProbe *probe, const Context *context, SourceStore *sources,
                                 const MethodChoice *choice, const Atmosphere *atmosphere, Error *error);
void sky_probe_destroy(SkyProbe *probe);

/* Looks up `count` directions: 4 floats each, unit vectors whose fourth number is not used. The radiances are
 * 4 floats each, RGB and 1. */
MUST_CHECK bool sky_probe_ask(SkyProbe *probe, const SkyState *state, const float *directions, size_t count,
                              float *radiances, Error *error);

/* Measures the seconds of one lookup. It draws 65536 of `directions` (or as many as there are) again and
 * again for about `seconds`, at least once, without reading results, and takes the fastest draw. */
MUST_CHECK bool sky_probe_time(SkyProbe *probe, const SkyState *state, const float *directions, size_t count,
                               double seconds, double *lookup_seconds, Error *error);
