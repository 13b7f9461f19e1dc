/* The sun by place and time: the settings sun.when, sun.where and sun.north. */
#pragma once

#include "scene/almanac.h"
#include "scene/moment.h"
#include "scene/scene_values.h"

/* A clock without moment and place. */
SunClock sun_clock_none(void);

/* Whether both the moment and the place are known, so that they say where the sun stands. */
bool sun_clock_runs(const SunClock *clock);

/* These need a clock that runs. */
Moment sun_clock_moment(const SunClock *clock);
Place sun_clock_place(const SunClock *clock);
/* Where the sun then stands in the scene: its azimuth is counted from +z toward +x. */
SunPlace sun_clock_sun(const SunClock *clock);

/* Appends such as "2026-06-21 20:30 +02:00 at 48.14, 11.58". The clock must run. */
void sun_clock_print(const SunClock *clock, Text *out);

/* These set one of the settings from a text, and with it the sun if the clock then runs. STATUS_USAGE names
 * the setting. */
MUST_CHECK bool sun_clock_set_when(SceneValues *values, const char *name, const char *text, Error *error);
MUST_CHECK bool sun_clock_set_where(SceneValues *values, const char *name, const char *text, Error *error);
MUST_CHECK bool sun_clock_set_north(SceneValues *values, const char *name, const char *text, Error *error);

/* Sets the clock's moment and the sun with it. The clock must run. */
void sun_clock_set_utc(SceneValues *values, double utc_s);

/* Fails (STATUS_USAGE) if there is a moment without a place or a place without a moment. */
MUST_CHECK bool sun_clock_check(const SunClock *clock, Error *error);
