/* Spheres from a CSV file. */
#pragma once

#include "source/source_store.h"

/* Rows `x,y,z,radius` in metres, in any number of columns more; empty lines, # comments and a header line
 * that starts with x are passed over. `spheres` gets 4 floats each, to be freed. STATUS_SCENE with
 * "path:line: ...", for numbers past 1e7, radii that are not above 0, and more than `most` rows. */
MUST_CHECK bool sphere_file_parse(const SourceFile *file, int most, float **spheres, int *count,
                                  Error *error);
