/* The progressive renderer draws a scene with the chosen methods into a film. One pass adds one group of
 * samples to each pixel.
 *
 * Sample n of a pixel depends only on the pixel, n and the seed, and groups are aligned. So the picture after
 * n samples is the same to the bit, however the work was cut into passes. */
#pragma once

#include "gl/camera.h"
#include "gl/film.h"
#include "gl/strips.h"
#include "render/chain_pass.h"
#include "render/image_pass.h"
#include "render/photon_pass.h"

typedef struct Renderer {
    const GlApi *gl;
    /* What was chosen, and what the parameters said. */
    Plan plan;
    bool variance, rejects;
    unsigned seed;
    uint64_t first_sample;
    /* What was asked for; empty for the whole picture. */
    Rectangle crop;
    /* The part of the picture that is drawn. */
    Rectangle area;
    /* Whether the picture is a first group that was stopped, so that its last rows are missing. */
    bool partial;
    /* The claimed relRMSE of the sky (choice/bias.h), percent; NAN if it is not known. */
    double sky_bias_percent;
    /* Whether all light of the sun's disk is found only by luck, as rare bright samples. For `sampled`, which
     * leaves only some of it to luck, the film counts how much (render/chance.h). */
    bool sun_by_chance;
    Program program;
    Resources tables;
    /* The part of the tables that is ready, as resources_prepare_for() tells it. Nothing can be drawn before
     * it is 1. */
    double prepared;
    /* Whether the programs have drawn their first pixel, before which drivers put compiling off. */
    bool warm;
    /* It holds the picture of before until the tables are ready. */
    Film film;
    Camera camera;
    /* Where the picture may hold the sun's own image. */
    SunImage sun_image;
    /* The pass that draws the sun's own image. */
    ImagePass image;
    /* The passes that trace light from the sun. */
    PhotonPass light;
    /* The passes of --sequence metropolis. */
    ChainPass chains;
    /* How fast the passes draw, and, for renderer_advance(), how many pixels of groups of samples; measured.
     * They set the size of the draws. */
    Pace pace;
    double pixels_per_second;
    /* For renderer_advance(): the size of the group in progress, 0 if there is none, and its first row that
     * is not drawn yet. If that is the film's height, only splatted light is missing. */
    unsigned group;
    int row;
    /* The paths of the files that the program which traces the paths was compiled from, with blanks between.
     */
    Text source_files;
} Renderer;

/* Compiles the programs. Drivers put compiling off until the first draw, so one pixel is drawn and thrown
 * away. The tables are filled, or with params->in_steps only begun. Methods or loops beyond their limits are
 * STATUS_USAGE, errors in GLSL are STATUS_SCENE. */
MUST_CHECK bool renderer_create(Renderer *renderer, const Context *context, const RenderParams *params,
                                Error *error);
void renderer_destroy(Renderer *renderer);

/* Removes the picture and starts anew, as renderer_create() would with these parameters, for the same scene
 * file. Sun, camera, size, parameters and air may have changed. Programs are kept unless the methods or the
 * film's parts have changed, and tables unless what they depend on has. If the parameters are refused, the
 * renderer is unchanged. */
MUST_CHECK bool renderer_restart(Renderer *renderer, const Context *context, const RenderParams *params,
                                 Error *error);

/* Goes on with the tables for about `seconds`, or until `stop` (may be NULL) returns true, if they are not
 * ready. The parameters are those of the last start. */
MUST_CHECK bool renderer_prepare(Renderer *renderer, const RenderParams *params, double seconds,
                                 bool (*stop)(void), Error *error);

/* Makes the tracing program the one in use, for a group of so many samples that the film takes in next. The
 * passes below do it by themselves. */
void renderer_begin_group(Renderer *renderer, unsigned group);

/* Adds one group of at most `samples` samples to each pixel. It draws strips of rows, so that `stop` (may be
 * NULL) is called about ten times a second. When `stop` returns true, the unfinished group is dropped; if it
 * is the first, its finished rows are kept. Returns false on failure only, not when stopped. */
MUST_CHECK bool renderer_pass(Renderer *renderer, uint64_t samples, bool (*stop)(void), Error *error);

/* Adds `samples`, at most group_samples, to each pixel of these regions, which must not overlap. film.samples
 * does not change. The other pixels must have been copied with film_keep(). When `stop` returns true, nothing
 * is added. */
MUST_CHECK bool renderer_refine(Renderer *renderer, const Rectangle *regions, int count, unsigned samples,
                                bool (*stop)(void), bool *stopped, Error *error);

/* Traces so many light paths more, in whole rows, or fewer when `stop` (may be NULL) returns true.
 * film.light_paths counts them. The other passes trace those that belong to their samples by themselves. */
MUST_CHECK bool renderer_light(Renderer *renderer, uint64_t paths, bool (*stop)(void), Error *error);

/* Whether light paths are missing that belong to the film's samples, because renderer_pass() was stopped. */
bool renderer_is_behind(const Renderer *renderer);

/* Traces these, until `stop` (may be NULL) returns true. */
MUST_CHECK bool renderer_catch_up(Renderer *renderer, bool (*stop)(void), Error *error);

/* Saves the picture so far, or loads it into a renderer that was just made with the same parameters. */
MUST_CHECK bool renderer_archive(Renderer *renderer, Archive *archive, Error *error);

/* Draws for about `seconds` (at least two rows), or until `stop` (may be NULL) returns true. It continues the
 * unfinished group, or starts one of at most `samples`, and commits it after its last row. Other programs and
 * textures may have been in use in between. Do not mix it with the passes above. */
MUST_CHECK bool renderer_advance(Renderer *renderer, uint64_t samples, double seconds, bool (*stop)(void),
                                 Error *error);
