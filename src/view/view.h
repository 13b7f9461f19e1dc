/* The window. A loop handles events, draws for some milliseconds, and shows the picture so far. */
#pragma once

#include "view/view_params.h"

/* Runs until the window is closed. Fails with STATUS_NO_GL if there is no display, and with STATUS_SCENE if
 * the scene does not compile at the start. */
MUST_CHECK bool view_run(const ViewParams *params, Error *error);
