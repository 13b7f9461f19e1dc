/* What somebody may want to change in a scene on Shadertoy, as constants with names. */
#pragma once

#include "scene/scene.h"
#include "source/glsl_tokens.h"

/* Appends the camera, the sun and the exposure: constants in capitals that glsl/pass/shadertoy_trace.glsl and
 * shadertoy_image.glsl take. Where the scene has iMouse for itself, the sun stays. */
void toy_settings_common(const Scene *scene, int max_hits, unsigned seed, Text *text);

/* Finds the scene's parameters among the uniforms of a text, and adds the names that they have there. */
void toy_settings_find(const Scene *scene, const GlslTokens *tokens, Names *found);

/* Appends those parameters, with their labels and ranges. */
void toy_settings_parameters(const Scene *scene, const Names *found, Text *text);

/* Appends words for a comment: what would end or continue the line becomes a blank. */
void toy_settings_comment(const char *words, Text *text);
