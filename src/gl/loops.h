/* How many loop iterations a driver lets one run of a shader make. */
#pragma once

#include "gl/gl_api.h"

/* Sets `limit` to the iterations after which the driver ends all loops of a shader without an error, as
 * Mesa's llvmpipe does before version 25 (65,535). It is 0 if the driver made all of the 70,000 that it was
 * asked for. Draws one pixel. */
MUST_CHECK bool loops_probe(const GlApi *gl, long *limit, Error *error);
