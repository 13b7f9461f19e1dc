/* What a picture's shader is made of, before anything of OpenGL: what the scene needs, the methods, how many
 * samples a draw may take, and the text of it all. */
#pragma once

#include "choice/method.h"
#include "gl/context.h"
#include "scene/glsl_source.h"
#include "scene/scene.h"

#include <stdint.h>

typedef struct RenderParams {
    const Scene *scene;
    const char *library;                /* folder of the GLSL library */
    const char *sky, *light, *sequence; /* NULL for the default; the scene's own sky comes before it */
    const char *sun_disk;               /* NULL for what the scene says */
    int width, height;                  /* 0 for the scene's */
    unsigned seed;
    int max_hits;         /* 0 is unlimited */
    uint64_t samples;     /* that will be taken a pixel, for auto's choice; 0 is as many as the error takes */
    double error_percent; /* asked for; 0 for auto's own idea of it (choice/auto.h) */
    bool variance;        /* whether the film is to know its error (film_read_variance) */
} RenderParams;

/* What a scene's own text and its includes say, so that nothing more is compiled and errors are about the
 * scene. */
typedef struct SceneNeeds {
    bool search;            /* whether its rays search by loops (glsl/shape/search.glsl) */
    long search_iterations; /* of one ray */
    bool emits;             /* whether one of its materials does */
    bool shiny;             /* whether some are neither matte nor mirrors */
    /* Whether a material may throw light in narrow lobes or single directions, as mirrors and glass do. */
    bool throws;
    /* The materials' names by their numbers; those beyond are left out. */
    char materials[20][24];
    unsigned inputs; /* render/inputs.h */
} SceneNeeds;

typedef struct Plan {
    MethodChoice sky, light, sequence, sun;
    SceneNeeds needs;
    int max_hits;
    unsigned group_samples; /* that the loops of one draw allow */
} Plan;

/* All of it. `context` is where it will be drawn, and is asked for its limit of loops; NULL for a plan of
 * which only the text is wanted. STATUS_USAGE for methods or loops beyond their limits, STATUS_SCENE for what
 * is wrong with the scene. */
MUST_CHECK bool plan_make(Plan *plan, const RenderParams *params, const Context *context, Error *error);

/* The methods alone, with what auto takes, by plan->needs. */
MUST_CHECK bool plan_choose_methods(Plan *plan, const RenderParams *params, Error *error);

/* The fragment shader as one text: the methods, the scene and what they include. `image`: the program that
 * draws the sun's own image too. */
MUST_CHECK bool plan_flatten(const Plan *plan, const RenderParams *params, bool image, GlslSource *source,
                             Error *error);

/* Whether the film counts what is left to chance (FILM_CHANCE). */
bool plan_counts_chance(const Plan *plan);

/* What the light method looks up: the irradiance of the open sky; the sky by its brightness. */
bool plan_controls(const Plan *plan);
bool plan_samples_sky(const Plan *plan);

/* The picture's size, pixels. */
int plan_width(const RenderParams *params);
int plan_height(const RenderParams *params);
