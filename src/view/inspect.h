/* Finds the figures of the pixel under the pointer. */
#pragma once

#include "render/aov.h"
#include "view/figures.h"

typedef struct Inspect {
    /* Created when it is first needed. */
    Aov aov;
    /* The scene for which the AOVs were made; owned. */
    Scene told;
    int width, height;
} Inspect;

/* Sets `figures` to those of a pixel of the renderer's picture, which is at rest. `params` are those that the
 * renderer was made with. */
MUST_CHECK bool inspect_pixel(Inspect *inspect, const Context *context, const RenderParams *params,
                              const Renderer *renderer, int x, int y, PixelFigures *figures, Error *error);

/* Call this when the scene's text has changed, and at the end. */
void inspect_destroy(Inspect *inspect);
