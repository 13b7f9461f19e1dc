/* One run of `render`, and what it prints: its choices, its result and its warnings. */
#pragma once

#include "cmd/options.h"
#include "cmd/progress.h"
#include "error/promise.h"
#include "image/attribute.h"
#include "image/image.h"
#include "render/aov.h"
#include "render/chance.h"
#include "render/check.h"
#include "render/renderer.h"

typedef struct RenderJob {
    const Options *options;
    /* The command line. */
    int argc;
    char **argv;
    Progress progress;
    char *library;
    Scene scene;
    Context context;
    /* Their scene is the one above. */
    RenderParams params;
    /* The methods that a checkpoint recalls. */
    Text recalled[5];
    Renderer renderer;
    Adaptive adaptive;
    unsigned aov_kinds;
    Aov aov;
    Image image;
    FilmCount count;
    FilmSearch search;
    ChanceShares chance;
    /* What is wrong with the scene's values. It is not looked for if the picture was interrupted. */
    Check check;
    /* Whether the layer of variances has pixels whose variance is not known. */
    bool variance_unknown;
    ProgressFigures figures;
    /* Seconds of rendering before this run, which --resume continues. */
    double earlier_seconds;
    /* Whether the last checkpoint was written, and whether it could not be. */
    bool checkpoint_written, output_missing;
    /* Whether the target error is promised. Means nothing without a target. */
    Promise promise;
} RenderJob;

/* The sky's bias in a measure, or NAN if it is not known. */
double render_bias(const RenderJob *job, NoiseMeasure measure);

/* Appends the lines that say what the samples depend on (render/identity.h). In levels, that is how the
 * picture is shown, too. */
MUST_CHECK bool render_identity(const RenderJob *job, Text *lines, Error *error);

/* Whether the picture is a part of another, or can be one (error/part.h). */
bool render_is_part(const Options *options);

/* Adds the metadata from which the picture can be made again, and what is known of its error. */
void render_describe(const RenderJob *job, AttributeList *list);

/* Prints the backend on standard error. */
void render_say_backend(const RenderJob *job);

/* Prints the methods, the backend and the files on standard error (-v). */
void render_say_choices(const RenderJob *job);

/* Prints the last line on standard output. */
void render_say_summary(const RenderJob *job);

/* Prints what may be wrong with the picture on standard error. */
void render_warn(const RenderJob *job);
