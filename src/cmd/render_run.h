/* The samples of `render`, from the first to the last. */
#pragma once

#include "cmd/render_job.h"

/* Takes samples until there are enough of them or until it is interrupted, and reads the picture. With
 * --resume it goes on with those of a checkpoint. */
MUST_CHECK bool render_run(RenderJob *job, Error *error);
