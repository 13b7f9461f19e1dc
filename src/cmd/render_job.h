/* One run of `render`, and its words: what was chosen, what came of it, and what to beware of. */
#pragma once

#include "cmd/options.h"
#include "cmd/progress.h"
#include "error/adaptive.h"
#include "image/image.h"
#include "render/aov.h"
#include "render/renderer.h"

typedef struct RenderJob {
    const Options *options;
    char *library;
    Scene scene;
    Context context;
    Renderer renderer;
    Adaptive adaptive;
    unsigned aov_kinds;
    Aov aov;
    Image image;
    FilmCount count;
    FilmSearch search;
    FilmChance chance;
    /* Somewhere in the layer of variances. */
    bool variance_unknown;
    ProgressFigures figures;
} RenderJob;

/* -v: the methods, the backend and the files, on standard error. */
void render_say_choices(const RenderJob *job);

/* The line at the end, on standard output. */
void render_say_summary(const RenderJob *job);

/* What may be wrong with the picture, on standard error. */
void render_warn(const RenderJob *job);
