/* What `info` prints of the sun at a place and a time. */
#pragma once

#include "scene/scene_values.h"

/* Prints where the sun stands, and the day's sunrise, sunset and twilights. The clock must run
 * (scene/sun_clock.h). */
void info_print_sun(const SunClock *clock);
