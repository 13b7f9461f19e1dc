/* What was measured, and on what, as lines that start with #: measurements under other lines are not mixed.
 */
#pragma once

#include "render/renderer.h"

/* The picture: scene, sun, size, and all other settings as a hash. */
void identity_of_picture(const RenderParams *params, Text *out);

/* The machine that the measurements are of. */
void identity_of_machine(const Context *context, Text *out);

/* Takes the shader that these methods make into the hash, which starts at 0. */
MUST_CHECK bool identity_add_shader(const RenderParams *params, uint64_t *hash, Error *error);
