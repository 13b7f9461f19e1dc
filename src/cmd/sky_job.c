#include "cmd/sky_job.h"

#include "base/vec3.h"
#include "choice/auto.h"
#include "cmd/setup.h"

#include <math.h>
#include <stdlib.h>

/* The target error for auto. It allows a third of it as bias, and a map has no other error. */
static const double map_error_percent = 0.3;
/* The same for the further orders, which take seconds, so that they and the sky err by 1 % at most. */
static const double map_further_error_percent = 3;

void sky_job_direction(double elevation_deg, double azimuth_deg, double out[3]) {
    double level = cos(elevation_deg * degree);
    out[0] = level * sin(azimuth_deg * degree);
    out[1] = sin(elevation_deg * degree);
    out[2] = level * cos(azimuth_deg * degree);
}

bool sky_job_open(SkyJob *job, const Atmosphere *air, double directions, Error *error) {
    AutoWish wish = {.error_percent = map_error_percent,
                     .samples = 1,
                     .pixels = directions,
                     .sun_elevation_deg = job->scene.values.sun.elevation_deg,
                     .atmosphere = air};
    AutoWish further_wish = wish;
    further_wish.error_percent = map_further_error_percent;
    MethodChoice choice, further;
    if (!setup_library(job->options, &job->library, error)) return false;
    job->sources = source_store_create(job->library);
    if (!auto_further(&further, job->options->further, job->options->sky, &further_wish, error) ||
        !auto_sky(&choice, job->options->sky, &further, &wish, error) ||
        !context_open(&job->context, job->options->backend, error) ||
        !sky_probe_create(&job->probe, &job->context, job->sources, &choice, air, error)) {
        return false;
    }
    job->probe.further = further;
    job->watch = (SkyWatch){gauge_watch_tables, &job->gauge};
    job->probe.watch = &job->watch;
    return true;
}

void sky_job_close(SkyJob *job) {
    sky_probe_destroy(&job->probe);
    context_close(&job->context);
    scene_destroy(&job->scene);
    source_store_release(job->sources);
    free(job->library);
}
