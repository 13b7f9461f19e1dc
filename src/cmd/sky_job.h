/* What the parts of `sky` share: the settings, and the sky method on the GPU. */
#pragma once

#include "cmd/gauge.h"
#include "scene/scene.h"
#include "sky/sky_probe.h"

typedef struct SkyJob {
    const Options *options;
    char *library;
    SourceStore *sources;
    /* Only the sky's settings are used. */
    Scene scene;
    Context context;
    SkyProbe probe;
    /* The method's full name. */
    const char *method;
    Gauge gauge;
    SkyWatch watch;
} SkyJob;

/* Chooses the method, for so many directions of one sun, and opens the probe. The probe's programs compute
 * the atmosphere `air`: the scene's, or one with the spectrum rgb. */
MUST_CHECK bool sky_job_open(SkyJob *job, const Atmosphere *air, double directions, Error *error);
void sky_job_close(SkyJob *job);

/* The unit vector at an elevation and an azimuth from +z toward +x. */
void sky_job_direction(double elevation_deg, double azimuth_deg, double out[3]);
