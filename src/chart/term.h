/* What the renderer can model or leave out, as a table: for each term whether a scene has it now, and how to
 * turn it off, or on. */
#pragma once

#include "render/renderer.h"

/* A scene and its methods, to be changed: `params.scene` is `scene`, which borrows what the original owns. */
typedef struct Variation {
    Scene scene;
    RenderParams params;
} Variation;

Variation *variation_create(const RenderParams *params); /* to be freed */

typedef enum TermState {
    TERM_NONE, /* there is nothing that it could change here */
    TERM_OFF,
    TERM_ON
} TermState;

typedef struct Term {
    char name[64];
    bool same_picture; /* in the mean: a way to compute it with less noise */
    TermState (*state)(const struct Term *term, const RenderParams *params, const Renderer *renderer);
    /* Turns it on or off, the other way from how it is; the variation's methods are named in full. */
    void (*turn)(const struct Term *term, Variation *variation, bool on);
    int number; /* of hits, nodes, or the scene's parameter */
} Term;

/* All terms that there are for this scene, checkboxes of its own among them; to be freed. */
Term *term_list(const RenderParams *params, int *count);
