/* The progressive renderer: a scene, the chosen methods and a film; one pass adds one group of samples to
 * each pixel.
 *
 * Sample n of a pixel depends on the pixel, n and the seed alone, and groups are aligned: the picture after n
 * samples is the same to the bit however the work was cut into passes. */
#pragma once

#include "gl/camera.h"
#include "gl/film.h"
#include "render/plan.h"
#include "render/spheres.h"
#include "sky/irradiance.h"
#include "sky/sky_sampler.h"
#include "sky/sun.h"

typedef struct Renderer {
    const GlApi *gl;
    Program program;
    Program
        image_program; /* the same with the sun's own image, for the pixels that may hold it; may be empty */
    GlslSource image_source; /* its text, of the same time as the other's: the files may change before the
                                image is in the picture */
    Film film;
    Camera camera;
    Sky sky;
    SunTables sun;
    SkyPatches patches; /* these are empty unless the light method asks for them */
    Irradiance irradiance;
    SkySampler sampler;
    Spheres spheres;
    MethodChoice light, sequence, sun_disk;
    double sky_bias_percent; /* claimed (choice/bias.h); NAN where it is not known */
    /* Whether all of the disk's light is found by chance: rare and bright. Of what `sampled` leaves to chance
     * the film knows (film_read_chance). */
    bool sun_by_chance;
    int max_hits;
    unsigned seed;
    unsigned group_samples;   /* per pass; the last pass may take fewer */
    double pixels_per_second; /* of a group, measured; sizes the draws */
    unsigned group;           /* renderer_advance: samples of the group that is being drawn ... */
    int row;                  /* ... whose rows before this one stand in the back of the film's target */
    unsigned parts;           /* of its films */
    SceneNeeds needs;
    bool ozone;                                  /* whether it was compiled in */
    double spheres_made_for[MOST_PARAMETERS][3]; /* the scene's, and its time */
    double spheres_time_s;
    Text source_files; /* what was compiled, for -v */
} Renderer;

/* The fragment shader that these parameters ask for, as one text: the methods, the scene and what they
 * include. */
MUST_CHECK bool renderer_flatten(const RenderParams *params, GlslSource *source, Error *error);

/* STATUS_USAGE for methods or loops beyond their limits, STATUS_SCENE for GLSL errors. Compiles, which
 * drivers put off to the first pixel: that is drawn and thrown away. */
MUST_CHECK bool renderer_create(Renderer *renderer, const Context *context, const RenderParams *params,
                                Error *error);
void renderer_destroy(Renderer *renderer);

/* Binds this renderer's tables again after another one was made or used in the same context. `scene` is as at
 * its creation. */
MUST_CHECK bool renderer_use(Renderer *renderer, const Scene *scene, Error *error);

/* Forgets the picture and starts anew as renderer_create() would with these parameters, for the same scene
 * file. Sun, camera, size, parameters and air may have changed freely: programs are kept unless methods have
 * changed, and tables unless what they depend on has. Where the parameters are refused, the renderer stays as
 * it was. */
MUST_CHECK bool renderer_restart(Renderer *renderer, const Context *context, const RenderParams *params,
                                 Error *error);

/* Tells `program`, which is in use, the values of the scene's own uniforms. */
void renderer_set_parameters(const Program *program, const Scene *scene);

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
