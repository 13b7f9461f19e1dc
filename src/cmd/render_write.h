/* The picture of a render, as it is read from the film and written to its files. */
#pragma once

#include "cmd/render_job.h"

/* How a PNG and levels show the picture. */
Tone render_tone(const Options *options);

/* Reads the picture that there is so far. To be freed: `image`. */
MUST_CHECK bool render_read(RenderJob *job, Error *error);

/* Writes the picture that was read last, with its metadata, to all outputs. */
MUST_CHECK bool render_write(const RenderJob *job, Error *error);
