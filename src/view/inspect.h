/* The pixel under the pointer. */
#pragma once

#include "render/aov.h"
#include "view/figures.h"

typedef struct Inspect {
    /* Made when it is first asked for. */
    Aov aov;
    /* The scene that it knows; owned. */
    Scene told;
    int width, height;
} Inspect;

/* Of the picture that `renderer` has at rest, for which it was made with `params`. */
MUST_CHECK bool inspect_pixel(Inspect *inspect, const Context *context, const RenderParams *params,
                              const Renderer *renderer, int x, int y, PixelFigures *figures, Error *error);

/* To be called when the scene's text has changed, and at the end. */
void inspect_destroy(Inspect *inspect);
