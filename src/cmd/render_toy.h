/* `render` of a file that paints a picture by itself, and has no scene (render/toy.h). */
#pragma once

#include "cmd/render_job.h"

/* Whether the job's scene is such a file. */
bool render_is_toy(const RenderJob *job);

/* Refuses --frames for what is a scene (STATUS_USAGE). */
MUST_CHECK bool render_check_frames(const RenderJob *job, Error *error);

/* Draws frame 0 at the scene's iTime, or with --frames N that one and those after it until frame N - 1, at
 * one place of each pixel or, with --spp N, at N whose colours are averaged, and writes the outputs. A PNG
 * holds the colours as they are, an EXR what the program wrote. Options that such a file has no use for are
 * STATUS_USAGE. */
MUST_CHECK bool render_toy(RenderJob *job, int argc, char **argv, Error *error);
