/* What the user may set in a scene: the camera, the sun, the air, and the scene's own parameters. */
#pragma once

#include "scene/atmosphere.h"
#include "scene/sun.h"

#include <stdbool.h>

enum { MOST_PARAMETERS = 32 };

/* Where the camera stands and looks, metres, and its full vertical angle. */
typedef struct Viewpoint {
    double eye[3], target[3], fov_deg;
} Viewpoint;

/* When and where the sun is looked up (scene/sun_clock.h). */
typedef struct SunClock {
    /* The moment (scene/moment.h). utc_s is NAN if none is set, or if the sun was moved by hand since. */
    double utc_s, zone_s;
    /* The place (scene/almanac.h). The first two are NAN if none is set. */
    double latitude_deg, longitude_deg, height_m;
    /* The scene's azimuth of true north. */
    double north_deg;
} SunClock;

typedef struct SceneValues {
    Viewpoint camera;
    Sun sun;
    SunClock clock;
    double exposure_ev;
    /* Shadertoy's iTime and iMouse, for scenes that want them. */
    double time_s, mouse[4];
    Atmosphere atmosphere;
    /* By the number of the parameter's declaration (SceneFile). A slider and a checkbox (0 or 1) have [0]
     * alone; the other two are 0. */
    double parameters[MOST_PARAMETERS][3];
    /* Whether the sun is there itself, beside the sky that it lights. */
    bool sun_disk;
    /* A bit for each kind of hint that is to be left out, as if the scene had none (scene/hint.h). */
    unsigned ignored_hints;
} SceneValues;

/* Whether all values are the same to the bit. */
bool scene_values_same(const SceneValues *a, const SceneValues *b);
