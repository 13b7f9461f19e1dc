/* The passes of a picture as data: which programs there are, what their texts are made of, which tables they
 * look things up in, and what they are told. Nothing here needs OpenGL, so that a picture's programs can be
 * written down where there is none. */
#pragma once

#include "gl/resource.h"
#include "render/plan.h"
#include "scene/glsl_slots.h"
#include "sky/frame.h"

/* The kinds of table that a picture may have, each after its inputs; ends with NULL. */
extern const ResourceKind *const picture_tables[];

/* One program. */
typedef struct Pass {
    /* "trace", or the name of the table that it fills. */
    const char *name;
    /* The library's file that its text starts from. */
    const char *entry;
    /* The table that it fills; NULL for a pass that draws into the film or into layers. */
    const ResourceKind *fills;
    /* Whether it draws the sun's own image. */
    bool image;
} Pass;

enum { MOST_PASSES = MOST_RESOURCES + 3 };

typedef struct PassList {
    Pass passes[MOST_PASSES];
    int count;
} PassList;

/* The passes that draw into the film, and the one that draws layers (--aov). */
extern const Pass trace_pass, sun_image_pass, aov_pass_entry;

/* All programs that a picture by this plan may need, in the order in which they are drawn. */
PassList pass_list(const Plan *plan, const RenderParams *params);

/* The text of a pass. */
MUST_CHECK bool pass_text(const Pass *pass, const Plan *plan, const RenderParams *params, GlslSource *source,
                          Error *error);

/* The text of the program that traces the paths, for those who want nothing else of a picture. */
MUST_CHECK bool pass_trace_text(const RenderParams *params, GlslSource *source, Error *error);

/* What the tables and the programs of a picture are made from: it borrows the plan and the scene. */
Frame frame_of(const Plan *plan, const Scene *scene, const Camera *camera);

/* What the frame tells all programs. The tables add what they tell (resources_prepare()). */
void frame_uniforms(const Frame *frame, const Plan *plan, unsigned seed, Uniforms *uniforms);
