/* What the observer sees of the planet, and what a table of the sky depends on. */
#pragma once

#include "base/text.h"
#include "scene/atmosphere.h"

/* The sine of the elevation of the observer's visible horizon, at most 0. */
double sky_horizon_sine(const Atmosphere *atmosphere);

/* The sine of the elevation at which the air ends, seen from above it; 1 from within. */
double sky_limb_sine(const Atmosphere *atmosphere);

/* Appends all that the sky depends on except the sun's azimuth: tables of the sky are turned to the azimuth
 * when they are read. `frame` is a Frame. */
void sky_key(const void *frame, Text *key);
