/* Where the observer sees the planet and the air end, and what tables of the sky depend on. */
#pragma once

#include "base/text.h"
#include "scene/atmosphere.h"

/* The sine of the elevation of the observer's visible horizon. It is 0 on the ground and below 0 above it. */
double sky_horizon_sine(const Atmosphere *atmosphere);

/* The sine of the elevation at which the air ends for an observer above it. It is 1 for one within. */
double sky_limb_sine(const Atmosphere *atmosphere);

/* A ResourceKind's key() for tables of the sky: all that the sky depends on, except the sun's azimuth. The
 * tables are turned to the azimuth when they are read. `frame` is a Frame. */
void sky_key(const void *frame, Text *key);
