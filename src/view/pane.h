/* One picture of the window as it converges: a renderer that is told of every change, a coarser preview while
 * things move, and what was measured. */
#pragma once

#include "error/noise.h"
#include "render/renderer.h"
#include "view/figures.h"
#include "view/state.h"

/* What a pane has to show; whatever differs from the last time starts the picture anew. */
typedef struct PaneParams {
    const Context *context;
    const char *library;
    const Scene *scene;
    const MethodNames *methods;
    int width, height;
    unsigned seed;
    int max_hits;
    uint64_t samples;   /* a pixel, after which the picture rests */
    bool moving;        /* something changed lately: a preview goes on */
    bool whole;         /* no previews: each picture is taken to its end */
    bool (*stop)(void); /* asked in the middle of a frame at rest: whether something is more urgent */
    double budget_s;    /* of time for a frame */
} PaneParams;

typedef struct Pane {
    Renderer renderer; /* its gl is NULL before the first update */
    Film kept; /* the picture of before, shown as long as the renderer's film is empty; may be empty itself */
    /* What the renderer was told; owned. */
    Scene scene;
    MethodNames methods;
    int width, height;        /* of the picture at rest */
    int coarseness;           /* the film has 1 / coarseness of them; 1 at rest */
    unsigned preview_samples; /* a pixel and frame; 0 at rest */
    double paths_per_second;  /* measured lately; 0 is not known */
    double preview_rate;      /* the same of previews */
    GLuint measured;          /* the program that was */
    double seconds;           /* spent on the picture */
    uint64_t paths;           /* of the picture */
    double error_percent;     /* estimated; NaN while it is not known */
    double mean; /* of the picture's radiance, over pixels and channels; 0 while it is not known */
    ErrorCurve curve;
    Noise noise;  /* of the picture at rest */
    bool changed; /* by the last update, other than from preview to rest */
} Pane;

/* Starts anew if anything has changed, with a preview, and with the picture itself when things rest. Where
 * that is refused (STATUS_USAGE, STATUS_SCENE) the pane goes on as it was. */
MUST_CHECK bool pane_update(Pane *pane, const PaneParams *params, Error *error);

/* After an edit of the files: compiles everything anew, and then takes it, so that of several panes all do or
 * none. The picture so far stays until the next has begun. */
MUST_CHECK bool pane_compile(const PaneParams *params, Renderer *next, Error *error);
void pane_take(Pane *pane, const PaneParams *params, const Renderer *next);
void pane_destroy(Pane *pane);

/* Draws for about the budget, and looks at the picture whenever its samples have doubled. */
MUST_CHECK bool pane_draw(Pane *pane, const PaneParams *params, Error *error);

/* Whether all samples were taken. */
bool pane_rests(const Pane *pane, const PaneParams *params);
