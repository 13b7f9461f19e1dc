/* One picture of the window. A pane has a renderer that follows every change. While something moves, it shows
 * a coarser preview. */
#pragma once

#include "view/estimate.h"
#include "view/figures.h"
#include "view/state.h"

/* What a pane has to show. Any change starts the picture anew. */
typedef struct PaneParams {
    const Context *context;
    const Scene *scene;
    const MethodNames *methods;
    int width, height;
    unsigned seed;
    int max_hits;
    /* The picture is done after this number of samples of each pixel. */
    uint64_t samples;
    /* Something changed lately, so the preview goes on. */
    bool moving;
    /* There are no previews, and each picture is rendered to its end. */
    bool whole;
    /* Called during a frame at rest. Returns true if something else is more urgent. */
    bool (*stop)(void);
    /* The time for a frame. */
    double budget_s;
} PaneParams;

typedef struct Pane {
    /* Its `gl` is NULL before the first update. */
    Renderer renderer;
    /* The previous picture. It is shown as long as the renderer's film is empty. It may be empty itself. */
    Film kept;
    /* The scene that the renderer shows; owned. */
    Scene scene;
    MethodNames methods;
    /* The size of the picture at rest. */
    int width, height;
    /* The film's width and height are those of the picture divided by this. 1 at rest. */
    int coarseness;
    /* Samples of each pixel in a frame of a preview. 0 at rest. */
    unsigned preview_samples;
    /* The speed that was measured last. 0 while it is not known. */
    double paths_per_second;
    /* The same for previews. */
    double preview_rate;
    /* The program whose speed was measured. */
    GLuint measured;
    /* When the picture was begun. */
    double begun;
    /* Time spent on the picture. */
    double seconds;
    /* Paths of the picture so far. */
    uint64_t paths;
    Estimate estimate;
    ErrorCurve curve;
    /* Whether the scene's values were checked since its file was read, and what is wrong with them: lines as
     * check_print() has them. */
    bool checked;
    char wrong[MOST_WRONG];
    /* Whether the last update changed the picture. A change from preview to rest does not count. */
    bool changed;
} Pane;

/* Starts anew if anything has changed: with a preview while something moves, and with the picture itself at
 * rest. If the change is refused (STATUS_USAGE, STATUS_SCENE), the pane goes on as it was. */
MUST_CHECK bool pane_update(Pane *pane, const PaneParams *params, Error *error);

/* After an edit of the files, pane_compile() compiles everything into `next`, and pane_take() puts `next` to
 * use. With several panes, compile all of them before you take the first, so that all change or none. The old
 * picture stays until the next one has begun. */
MUST_CHECK bool pane_compile(const PaneParams *params, Renderer *next, Error *error);
void pane_take(Pane *pane, const PaneParams *params, const Renderer *next);
/* Makes the next update start anew, with a preview. */
void pane_hurry(Pane *pane);
void pane_destroy(Pane *pane);

/* Says whether the tables are ready. Before that the pane shows the picture of before. */
bool pane_is_ready(const Pane *pane);

/* Draws for about the time of the budget, or computes the tables for about twice that time. The error is
 * estimated whenever the picture's samples have doubled.
 */
MUST_CHECK bool pane_draw(Pane *pane, const PaneParams *params, Error *error);

/* Says whether all samples were taken. */
bool pane_rests(const Pane *pane, const PaneParams *params);

/* Fills in what the overlay says of the picture. */
void pane_figures(const Pane *pane, SideFigures *figures);
