/* What the window's user has set before the first event. */
#pragma once

#include "view/view_params.h"

/* `state` is zero but for the scene of the file. */
void start_state(ViewState *state, const ViewParams *params);
