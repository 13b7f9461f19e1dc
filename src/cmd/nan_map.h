/* The picture of --nan-map: how many samples were left out of each pixel, and why. */
#pragma once

#include "cmd/render_job.h"

/* Checks the file's name before the work is done. */
MUST_CHECK bool nan_map_check(const Options *options, Error *error);

/* Writes the picture, if it is wanted. Its layers are
 *
 *     not_finite.Y   samples that were infinite or no number
 *     too_large.Y    samples whose group would have made the pixel's sum too large for a float
 *     loops.Y        samples in which the driver ended the loops
 *     points.Y       points of light, of paths from the sun or of Markov chains, that were left out
 *     negative.Y     samples that were added although a channel was negative
 *
 * and R, G and B are not_finite, the sum of the three after it, and negative. */
MUST_CHECK bool nan_map_write(const RenderJob *job, const AttributeList *attributes, Error *error);
