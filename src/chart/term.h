/* The terms of the model: what the renderer can model or leave out. For each term a table says whether a
 * scene has it now, and how to turn it off or on. */
#pragma once

#include "render/renderer.h"

/* A copy of a scene and its methods that may be changed. `params.scene` points to `scene`. What the original
 * scene owns is borrowed. */
typedef struct Variation {
    Scene scene;
    RenderParams params;
} Variation;

/* Returns a copy, to be freed. */
Variation *variation_create(const RenderParams *params);

typedef enum TermState {
    /* The term could change nothing in this scene. */
    TERM_NONE,
    TERM_OFF,
    TERM_ON
} TermState;

typedef struct Term {
    char name[64];
    /* Whether the term leaves the picture's mean as it is, because it is only a way to compute it with less
     * noise. */
    bool same_picture;
    TermState (*state)(const struct Term *term, const RenderParams *params, const Renderer *renderer);
    /* Turns the term on if it is off, or off if it is on. The variation's methods are named in full. */
    void (*turn)(const struct Term *term, Variation *variation, bool on);
    /* A number of hits or nodes, a degree, or the index of a parameter of the scene. */
    int number;
} Term;

/* Returns all terms for this scene, including the scene's own checkboxes. To be freed. */
Term *term_list(const RenderParams *params, int *count);
