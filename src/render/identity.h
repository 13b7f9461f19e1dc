/* What a picture is made of, as lines "name value": all that its samples depend on but their number. Samples
 * are added to each other only if these lines are the same. */
#pragma once

#include "render/renderer.h"

/* Appends the lines of the renderer's picture. `aov` is the list of further layers, or NULL. */
MUST_CHECK bool identity_print(const RenderParams *params, const Renderer *renderer, const char *aov,
                               Text *lines, Error *error);

/* Appends the value of the line of that name; false if there is none. */
bool identity_value(const char *lines, const char *name, Text *value);

/* Whether both have the same lines. If not, `difference` says what differs: "the seed was 1, and is 2 now" of
 * the first such line, and how many more there are. */
bool identity_same(const char *before, const char *now, Text *difference);
