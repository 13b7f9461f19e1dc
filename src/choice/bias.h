/* The bias of the sky's methods: how far a picture of infinitely many samples is from the true one.
 *
 * The figures are measured (choice/bias_figures.h). tests/test_bias.c holds them to pictures and to skies
 * that they were not measured from. */
#pragma once

#include "choice/method.h"
#include "scene/atmosphere.h"

/* relRMSE in percent of a sky method, with its table if it has one. The figure is 1.4 times the largest that
 * was measured, as other scenes differ. NAN where nothing was measured: for an air that is unlike
 * simmons2017 and earth, for a sun below -12 degrees, and for paper with fewer steps than 16x4. */
double bias_sky_percent(const MethodChoice *choice, double sun_elevation_deg, const Atmosphere *atmosphere);

/* The size of a table's half: the one that the user gave, or else one that is found. That is the smallest of
 * 16x48, 32x96, 64x192, 128x384 and 256x768 whose error is at most choice->table_size.percent at this
 * position of the sun, or the largest if none is so good. */
void bias_table_size(const MethodChoice *choice, double sun_elevation_deg, const Atmosphere *atmosphere,
                     int *columns, int *rows);
