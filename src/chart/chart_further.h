/* The second part of chart_sky(), for an air with further orders of scattering: the seconds in which their
 * tables are filled, once for an air, against the error of the sky, by the quality of --further. */
#pragma once

#include "chart/chart.h"
#include "sky/frame.h"

/* Writes further.csv, .svg and .png, and says so. `directions` are 4 floats for each of `count` directions,
 * and `truth` is 3 doubles for each: their radiances (sky/sky_truth.h). It is measured anew each time, in
 * some seconds. */
MUST_CHECK bool chart_further(const ChartParams *params, const SkyState *state, const float *directions,
                              const double *truth, int count, Error *error);
