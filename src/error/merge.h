/* Parts of one picture (part.h) become one. All samples count alike, whichever part they are from.
 *
 * The sums of the parts are added exactly, in the order of their samples, so that the result depends neither
 * on the order in which parts are named nor on how the samples were shared out, as long as each part begins
 * with a whole group of samples (renderer.h). */
#pragma once

#include "error/merged.h"

/* Reads the parts and puts them together. Parts of different pictures, or whose samples overlap, are
 * STATUS_FAILURE. `keeps_sums` says whether the result can be merged again. To be freed. */
MUST_CHECK bool merge_files(Merge *merge, const char *const *paths, int count, bool keeps_sums, Error *error);
void merge_free(Merge *merge);
