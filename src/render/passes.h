/* The passes of a picture as data: its programs, what their texts are made of, the tables that they read, and
 * their uniforms. Nothing here needs OpenGL, so `flatten` can write the programs without it. */
#pragma once

#include "gl/resource.h"
#include "render/plan.h"
#include "sky/frame.h"
#include "source/glsl_slots.h"

/* The kinds of tables that a picture may have, each after its inputs. The list ends with NULL. */
extern const ResourceKind *const picture_tables[];

/* A pass is one program. */
typedef struct Pass {
    /* "trace", or the name of the table that it fills. */
    const char *name;
    /* The library's file that its text starts from. */
    const char *entry;
    /* The table that it fills; NULL for a pass that draws into the film or into layers. */
    const ResourceKind *fills;
} Pass;

enum { MOST_PASSES = MOST_RESOURCES + 7 };

typedef struct PassList {
    Pass passes[MOST_PASSES];
    int count;
} PassList;

/* The passes of Markov chains (render/chain_pass.h): their steps, their numbers, and the film's own sum. */
extern const Pass chain_steps_pass, chain_keep_pass, chain_film_pass;

/* The pass that adds a group of samples to the film, and the one that traces the paths from the camera. */
const Pass *film_pass(const Plan *plan);
const Pass *paths_pass(const Plan *plan);

/* The passes that draw into the film, the one that draws layers (--aov), and the one that checks the scene's
 * values (render/check.h). */
extern const Pass trace_pass, sun_image_pass, aov_pass_entry, check_pass;

/* The passes of light that is traced from the sun (render/photon_pass.h). */
extern const Pass throwers_pass, photons_pass;

/* All programs that a picture with this plan may need, in the order in which they are drawn. */
PassList pass_list(const Plan *plan, const RenderParams *params);

/* Makes the text of a pass. */
MUST_CHECK bool pass_text(const Pass *pass, const Plan *plan, const RenderParams *params, GlslSource *source,
                          Error *error);

/* Compiles a pass's text. If the driver reports an error in the library's files, the message names the scene
 * too. */
MUST_CHECK bool pass_compile(Program *program, const GlApi *gl, const GlslSource *source,
                             const RenderParams *params, Error *error);

/* Makes the text of a pass and compiles it. */
MUST_CHECK bool pass_program(Program *program, const Pass *pass, const GlApi *gl, const Plan *plan,
                             const RenderParams *params, Error *error);

/* Makes the text of the program that traces the paths, without a plan. */
MUST_CHECK bool pass_trace_text(const RenderParams *params, GlslSource *source, Error *error);

/* The frame of a picture (sky/frame.h). It borrows the plan and the scene. */
Frame frame_of(const Plan *plan, const RenderParams *params, const Camera *camera);

/* Adds the uniforms that come from the frame. resources_prepare() adds those of the tables. */
void frame_uniforms(const Frame *frame, const Plan *plan, unsigned seed, Uniforms *uniforms);
