/* The identity of a measurement: lines that start with # and say what was measured, and on which machine.
 * Measurements with different identities are never mixed. */
#pragma once

#include "render/renderer.h"

/* Prints the picture's part of the identity: scene, sun, size, and a hash of all other settings. */
void identity_of_picture(const RenderParams *params, Text *out);

/* Prints the machine's part of the identity. */
void identity_of_machine(const Context *context, Text *out);

/* Adds the text of the shader that these methods make to the hash. A hash starts at 0. */
MUST_CHECK bool identity_add_shader(const RenderParams *params, uint64_t *hash, Error *error);
