/* `sky --at`: the radiances of listed directions. */
#pragma once

#include "cmd/sky_job.h"

/* Reads the rows of the file that --at names and writes them with their radiances: R,G,B, or with --spectrum
 * those of wavelengths. They go to the file of -o, or to standard output. */
MUST_CHECK bool sky_at(SkyJob *job, Error *error);
