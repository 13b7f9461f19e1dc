/* Columns of air from a point to the top of the atmosphere in closed form, in double precision. They are a
 * thousand times faster than the quadrature of sky/air_path.h. The error of an exponential layer is at most
 * 1e-5 of the column: it is Chapman's integral to second order in 1/X, where X is the distance from the
 * planet's centre in scale heights (glsl/sky/column.glsl). The ozone's column is exact. */
#pragma once

#include "sky/air_path.h"

/* The columns from altitude `height` to the top, along a ray of this rise (air_path.h), in metres of air of
 * the density at altitude 0. They are 0 above the top. A ray that descends must miss the ground. */
AirColumns air_column_to_top(const Atmosphere *atmosphere, double height, double rise);
