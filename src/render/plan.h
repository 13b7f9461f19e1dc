/* What is decided before anything of a picture is made: what the scene needs, the methods, and how many
 * samples a draw may take. */
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

enum { LOOP_LIMIT_UNKNOWN = -1 };

typedef struct Plan {
    MethodChoice sky, light, sequence, sun;
    SceneNeeds needs;
    int max_hits;
    /* That the loops of one draw allow. */
    unsigned group_samples;
    /* Loop iterations after which this OpenGL ends a shader's loops: 0 if it does not, and LOOP_LIMIT_UNKNOWN
     * until a plan came near the smallest limit that is known. */
    long loop_limit;
    /* Whether the air has ozone, which is compiled in. */
    bool ozone;
} Plan;

/* All of it. `context` is where it will be drawn, and is asked for its limit of loops; NULL for a plan of
 * which only the text is wanted. STATUS_USAGE for methods or loops beyond their limits, STATUS_SCENE for what
 * is wrong with the scene. */
MUST_CHECK bool plan_make(Plan *plan, const RenderParams *params, const Context *context, Error *error);

/* The same for a scene whose needs are in the plan. */
MUST_CHECK bool plan_choose(Plan *plan, const RenderParams *params, const Context *context, Error *error);

/* Whether the film counts what is left to chance (FILM_CHANCE). */
bool plan_counts_chance(const Plan *plan);

/* Whether the programs of one plan serve the other, for the same scene file and film. */
bool plan_same_programs(const Plan *a, const Plan *b);

/* The picture's size, pixels. */
int plan_width(const RenderParams *params);
int plan_height(const RenderParams *params);
