/* The further layers (AOVs) of a merged picture. */
#pragma once

#include "error/merged.h"

/* Adds the layers of first surfaces that all parts have. They are means over the samples of which
 * one run takes them, the first AOV_MOST_SAMPLES, up to rounding. `samples` is all of the samples. The
 * variance is not among them (merge_sums.h). */
MUST_CHECK bool merge_layers_add(Merge *merge, const double *samples, Error *error);
