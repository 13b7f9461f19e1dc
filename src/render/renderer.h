/* The progressive renderer: a scene, the chosen methods and a film; one pass adds one group of samples to
 * each pixel.
 *
 * Sample n of a pixel depends on the pixel, n and the seed alone, and groups are aligned: the picture after n
 * samples is the same to the bit however the work was cut into passes. */
#pragma once

#include "gl/camera.h"
#include "gl/film.h"
#include "render/passes.h"
#include "sky/sun.h"

typedef struct Renderer {
    const GlApi *gl;
    /* What was chosen, and asked for. */
    Plan plan;
    bool variance;
    unsigned seed;
    /* The claimed relRMSE of the sky (choice/bias.h), percent; NAN where it is not known. */
    double sky_bias_percent;
    /* Whether all of the disk's light is found by chance: rare and bright. Of what `sampled` leaves to chance
     * the film knows (film_read_chance). */
    bool sun_by_chance;
    Program program;
    /* The same with the sun's own image, for the pixels that may hold it. Empty until a picture has such
     * pixels; its text is made together with the other's, as the files may have changed by then. */
    Program image_program;
    GlslSource image_source;
    Resources tables;
    Film film;
    Camera camera;
    SunImage image;
    /* Of a group, measured; sizes the draws. */
    double pixels_per_second;
    /* renderer_advance(): the samples of the group in progress, and its first row that is not drawn yet; 0
     * when none is in progress. */
    unsigned group;
    int row;
    /* The paths of the files that were compiled, with blanks between. */
    Text source_files;
} Renderer;

/* STATUS_USAGE for methods or loops beyond their limits, STATUS_SCENE for GLSL errors. Compiles, which
 * drivers put off to the first pixel: that is drawn and thrown away. */
MUST_CHECK bool renderer_create(Renderer *renderer, const Context *context, const RenderParams *params,
                                Error *error);
void renderer_destroy(Renderer *renderer);

/* Forgets the picture and starts anew as renderer_create() would with these parameters, for the same scene
 * file. Sun, camera, size, parameters and air may have changed freely: programs are kept unless methods or
 * the film's parts have changed, and tables unless what they depend on has. Where the parameters are refused,
 * the renderer stays as it was. */
MUST_CHECK bool renderer_restart(Renderer *renderer, const Context *context, const RenderParams *params,
                                 Error *error);

/* Adds one group, at most `samples`. Drawn in strips of rows so that `stop` (may be NULL) is asked about ten
 * times a second: when it says yes, the unfinished group is dropped, or kept as far as it came if it is the
 * first. False on failure; being stopped is not one. */
MUST_CHECK bool renderer_pass(Renderer *renderer, uint64_t samples, bool (*stop)(void), Error *error);

/* Adds `samples`, at most group_samples, to each pixel of these regions, which do not overlap, and none
 * elsewhere; film.samples stays what it is. The film must hold the others (film_keep). When `stop` says yes,
 * nothing is added. */
MUST_CHECK bool renderer_refine(Renderer *renderer, const Rectangle *regions, int count, unsigned samples,
                                bool (*stop)(void), bool *stopped, Error *error);

/* Draws on for about `seconds` (at least a row), less if `stop` (may be NULL) says yes: the group that is
 * unfinished, or the next one, of at most `samples`. With its last row it is committed. Other programs and
 * textures may have been in use since. Not to be mixed with the passes above. */
MUST_CHECK bool renderer_advance(Renderer *renderer, uint64_t samples, double seconds, bool (*stop)(void),
                                 Error *error);
