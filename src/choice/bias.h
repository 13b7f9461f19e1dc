/* What the sky's methods err, as it shows in pictures: claims taken from measurements (tests/test_bias.c
 * holds them to it). All are relRMSE in percent. */
#pragma once

#include "choice/method.h"
#include "scene/atmosphere.h"

/* Of a sky method, with its table if it has one: the larger of what was measured in pictures and over the
 * sky, and 0.4 more, as scenes differ. NAN where nothing was measured: an air that is unlike the presets', a
 * sun below -12 degrees, paper with fewer steps than 16x4. */
double bias_sky_percent(const MethodChoice *choice, double sun_elevation_deg, const Atmosphere *atmosphere);

/* The size of a table: as it was asked for; else by the sun, the smallest that adds no more than
 * choice->table_percent, of those that double in both ways from 16x48 to 256x768, the largest where none is
 * so good. */
void bias_table_size(const MethodChoice *choice, double sun_elevation_deg, const Atmosphere *atmosphere,
                     int *columns, int *rows);
