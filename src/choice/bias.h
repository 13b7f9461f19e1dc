/* The bias of the sky's methods: how far a picture of infinitely many samples is from the true one.
 *
 * The figures are measured (choice/bias_figures.h). tests/test_bias.c holds them to pictures and to skies
 * that they were not measured from. */
#pragma once

#include "choice/method.h"
#include "scene/atmosphere.h"

/* relRMSE in percent of a sky method, with its table if it has one; without what the further orders of
 * scattering err. The figure is 1.4 times the largest that was measured, as other scenes differ; above 2 m it
 * is raised to 1.2 times what a scan of heights and suns saw (choice/bias_factors.h). NAN where nothing
 * holds: for an air that is unlike simmons2017 and earth, for an observer in the uppermost 3 km of the air,
 * for a sun below -12 degrees, for paper with fewer steps than 16x4, and for a table of fewer than 32 columns
 * in an air with further orders. */
double bias_sky_percent(const MethodChoice *choice, double sun_elevation_deg, const Atmosphere *atmosphere);

/* The same of the further orders of scattering, by how they are computed: 0 if the air has none. It is a
 * share of all light, as that of the sky is, so that the sum of both is claimed for the picture. */
double bias_further_percent(const MethodChoice *further, double sun_elevation_deg,
                            const Atmosphere *atmosphere);

/* The same, and where nothing was measured the figure of the nearest air and sun that were: no claim, but
 * enough to choose by. */
double bias_further_guess_percent(const MethodChoice *further, double sun_elevation_deg,
                                  const Atmosphere *atmosphere);

/* The size of a table's half: the one that the user gave, or else one that is found. That is the smallest of
 * 16x48 (not with further orders), 32x96, 64x192, 128x384 and 256x768 whose error is at most
 * choice->table_size.percent at this position of the sun, or the largest if none is so good. */
void bias_table_size(const MethodChoice *choice, double sun_elevation_deg, const Atmosphere *atmosphere,
                     int *columns, int *rows);
