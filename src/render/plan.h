/* The plan is decided before anything of a picture is made: what the scene needs, the methods, and how many
 * samples a draw may take. */
#pragma once

#include "base/rectangle.h"
#include "choice/method.h"
#include "gl/context.h"
#include "scene/scene.h"
#include "sky/sky_orders_plan.h"
#include "source/glsl_source.h"

#include <stdint.h>

/* What a picture is for. A window's pictures follow a sun and a camera that move: what they may need is
 * compiled before the first of them. */
typedef enum PictureUse {
    PICTURE_FILE,
    /* The tables that follow the sun are coarse. */
    PICTURE_PREVIEW,
    /* The tables that follow the sun are in steps too. */
    PICTURE_AT_REST
} PictureUse;

typedef struct RenderParams {
    const Scene *scene;
    /* NULL for the default. For the sky the default is the scene's own, if it has one. */
    const char *sky, *further, *light, *sequence;
    /* NULL for the scene's. */
    const char *sun_disk;
    /* In pixels; 0 for the scene's. */
    int width, height;
    unsigned seed;
    /* The number of the picture's first sample, where others have those before it. */
    uint64_t first_sample;
    /* The part of the picture that is rendered; all of it if this is empty. */
    Rectangle crop;
    /* 0 for no limit. */
    int max_hits;
    /* The number of samples that each pixel will get, for auto's choice; 0 if the error decides. */
    uint64_t samples;
    /* The target relRMSE, percent; 0 if the user gave none, then auto estimates it (choice/auto.h). */
    double error_percent;
    /* Whether the film must have FILM_SCATTER, for film_read_variance(). */
    bool variance;
    /* Whether it must have FILM_REJECTS, for film_read_rejects(). */
    bool rejects;
    /* Whether a renderer may be returned whose tables in steps are not ready, for renderer_prepare(). */
    bool in_steps;
    /* Asked while the tables are filled, several times a second, for the share of them that is ready; NULL if
     * nobody waits. If it stops a start that must make them ready, that fails with STATUS_INTERRUPTED. */
    const SkyWatch *watch;
    PictureUse use;
} RenderParams;

/* What the scene needs, found by scanning its flattened text. Features that it does not need are not
 * compiled, and errors in it are reported against the scene. */
typedef struct SceneNeeds {
    /* Whether its rays search by loops (glsl/shape/search.glsl). */
    bool search;
    /* Loop iterations of one ray's search. */
    long search_iterations;
    /* Whether one of its materials emits light. */
    bool emits;
    /* Whether a material is neither matte nor a mirror. */
    bool shiny;
    /* Whether a material may reflect or refract light in narrow lobes or single directions, as mirrors and
     * glass do. */
    bool throws;
} SceneNeeds;

/* The second is the smallest number of iterations at which a driver is known to end all loops of a shader
 * (llvmpipe before Mesa 25). A driver's own limit is measured only if a draw needs more. */
enum { LOOP_LIMIT_UNKNOWN = -1, PLAN_LEAST_LOOP_LIMIT = 65535 };

typedef struct Plan {
    MethodChoice sky, further, light, sequence, sun;
    SceneNeeds needs;
    int max_hits;
    /* The number of samples for which the loops of one draw suffice. */
    unsigned group_samples;
    /* The number of loop iterations after which this OpenGL ends a shader's loops: 0 if it never does, and
     * LOOP_LIMIT_UNKNOWN until a plan comes near the smallest limit known. */
    long loop_limit;
    /* Whether the air has ozone, and how its colours are computed. They are compiled in. */
    bool ozone;
    double spectrum;
    /* Whether there is mist between the surfaces. */
    bool mist;
    /* Whether it is the atmosphere's air. */
    bool air;
    /* Whether the sky has light beyond the first order of the air, and whether it has further orders. */
    bool has_further, has_orders;
    /* Whether the film has nothing but the sum of the samples: neither searches nor the light that is left to
     * chance are counted. */
    bool uncounted;
} Plan;

/* Makes the plan. `context` is where the picture will be drawn, and its limit of loops may be measured there;
 * NULL for a plan of which only the text is wanted. Methods or loops beyond their limits are STATUS_USAGE,
 * faults of the scene are STATUS_SCENE. */
MUST_CHECK bool plan_make(Plan *plan, const RenderParams *params, const Context *context, Error *error);

/* Makes all of the plan but `needs`, which must be there already. */
MUST_CHECK bool plan_choose(Plan *plan, const RenderParams *params, const Context *context, Error *error);

/* Lowers the hits of a path and the samples of a draw, so that a draw has no more than `limit` loop
 * iterations. STATUS_USAGE where a single sample needs more. */
MUST_CHECK bool plan_fit_loops(Plan *plan, const RenderParams *params, long limit, Error *error);

/* Whether the film counts the light that is left to chance (FILM_CHANCE). Chains find it by other odds. */
bool plan_counts_chance(const Plan *plan);

/* Whether the film counts rays that search by steps (FILM_SEARCH). */
bool plan_counts_searches(const Plan *plan);

/* Whether both plans have the same programs, for the same scene file and film. */
bool plan_same_programs(const Plan *a, const Plan *b);

/* The picture's size in pixels. */
int plan_width(const RenderParams *params);
int plan_height(const RenderParams *params);
