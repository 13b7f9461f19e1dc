/* Light paths from the sun's disk (glsl/pass/photons.glsl). They are for light that glass, metal and mirrors
 * throw on other surfaces, which paths from the camera find only by luck. Each batch of them is traced into
 * a texture, of which each texel is a point that is added to the film's second sum. */
#pragma once

#include "gl/film.h"
#include "render/aim.h"
#include "render/passes.h"

typedef struct PhotonPass {
    const GlApi *gl;
    Program throwers, photons;
    /* A batch: points of light, and starts, which are read only when the paths are aimed. */
    GLuint points, starts, framebuffer;
    /* The tree of the aim. */
    GLuint tree;
    Aim aim;
    /* Light paths for each sample of all pixels together; 0 if none are traced. */
    double paths_a_sample;
    /* The number of the first light path: that of the picture's first sample. */
    uint64_t first;
    /* The number of that sample. */
    uint64_t before;
    /* Measured; it sets the size of batches where time is short, and of draws. */
    double paths_per_second;
    bool measured;
} PhotonPass;

/* Creates the pass if the plan's method traces light; else `pass` is an empty struct. Errors in GLSL are
 * STATUS_SCENE. */
MUST_CHECK bool photon_pass_create(PhotonPass *pass, const Context *context, const Plan *plan,
                                   const RenderParams *params, Error *error);
void photon_pass_destroy(PhotonPass *pass);

/* Aims the paths at what throws light into this picture, with the programs' uniforms and tables set. If
 * `traces` is false, or nothing throws light, there will be no paths. */
MUST_CHECK bool photon_pass_aim(PhotonPass *pass, const Frame *frame, bool traces, Error *error);

/* Tells the program that traces paths from the camera, which must be in use, how light paths are aimed. */
void photon_pass_give(const PhotonPass *pass, const Program *trace);

/* The number of paths that the film lacks if it has so many samples in all pixels. */
uint64_t photon_pass_due(const PhotonPass *pass, const Film *film, double samples);

/* Traces about `paths` paths, or as many as a batch has or as take `seconds`, into the film. They are whole
 * rows of a batch, and there is at least one. Returns how many paths they are. */
uint64_t photon_pass_draw(PhotonPass *pass, Film *film, uint64_t paths, double seconds);
