/* Markov chains over paths (Metropolis light transport in primary sample space; glsl/pass/metropolis.glsl).
 *
 * Each chain draws a few candidates, and one of them is chosen in proportion to its brightness. These starts
 * are shared out among all chains (render/chain_starts.h), which then weigh the mean brightness of all
 * candidates. The picture is right on average from the first step on: there is no time of settling (Veach
 * 1997). The chains begin anew now and then. In each step all chains propose a path, and the light of both
 * paths is added to the film's second sum, by how likely the chain is to be at each.
 *
 * The numbers of a step follow from the chain, the step and the seed, so that the picture is the same to the
 * bit however the steps are cut into draws. */
#pragma once

#include "gl/film.h"
#include "render/passes.h"

typedef struct ChainPass {
    const GlApi *gl;
    Program steps, keep;
    /* The chains' points of light and their state, and the numbers that they remember. */
    Target chains, numbers;
    /* The points of all chains in a step, as they are read back. */
    float *points;
    /* The chain from which each chain takes its start, as a texture and as its texels, and what all chains
     * then weigh. */
    GLuint sources;
    float *source_texels;
    double mean;
    unsigned seed;
    /* Rows of chains that this picture has. */
    int rows;
    /* The number of the next step. */
    uint64_t next;
    /* Measured; it sets how many steps are drawn where time is short. */
    double steps_per_second;
} ChainPass;

/* Saves the chains, or loads them. */
MUST_CHECK bool chain_pass_archive(ChainPass *pass, Archive *archive, Error *error);

/* Creates the pass if the plan's sequence walks chains; else `pass` is an empty struct. Errors in GLSL are
 * STATUS_SCENE. */
MUST_CHECK bool chain_pass_create(ChainPass *pass, const Context *context, const Plan *plan,
                                  const RenderParams *params, Error *error);
void chain_pass_destroy(ChainPass *pass);

/* Begins a picture of this size, with the programs' uniforms and tables set. */
MUST_CHECK bool chain_pass_begin(ChainPass *pass, int width, int height, unsigned seed, Error *error);

/* The number of proposed paths that the film lacks if it is to have one for each sample of each pixel. */
uint64_t chain_pass_due(const ChainPass *pass, const Film *film, double samples);

/* Draws steps of all chains until `paths` paths are proposed, or as many as a call may take or as take
 * `seconds`, but at least one. Returns how many paths were added to the film: none, while the chains look for
 * their start. A film without light begins anew. */
uint64_t chain_pass_draw(ChainPass *pass, Film *film, uint64_t paths, double seconds);
