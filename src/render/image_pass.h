/* The pass that draws the sun's own image. It sums the image's radiance over a group of samples, for the few
 * pixels that may hold it, and the tracing program then adds these sums to its group. */
#pragma once

#include "gl/film.h"
#include "render/passes.h"
#include "sky/sun.h"

typedef struct ImagePass {
    const GlApi *gl;
    /* It is empty until the first picture that holds the image, or a window's first. */
    Program program;
    /* The sums of the last group. It has the film's size if the picture holds the image, and is small if it
     * does not. */
    GLuint texture, framebuffer;
    int width, height;
    /* Where the picture may hold the image. */
    SunImage where;
    /* Measured; it sets the size of the draws. */
    double pixel_samples_per_second;
} ImagePass;

/* Creates the pass if the plan's method draws the image; else `pass` is an empty struct. */
MUST_CHECK bool image_pass_create(ImagePass *pass, const Context *context, const Plan *plan, Error *error);
void image_pass_destroy(ImagePass *pass);

/* Compiles the program if this picture is the first that holds the image, or at once for a window. Errors in
 * GLSL are STATUS_SCENE. */
MUST_CHECK bool image_pass_compile(ImagePass *pass, const SunImage *image, const Plan *plan,
                                   const RenderParams *params, Error *error);

/* Begins a picture of this size with all sums zero. */
void image_pass_begin(ImagePass *pass, const SunImage *image, int width, int height);

/* Draws one pixel and removes it, because drivers compile a program when it first draws. */
void image_pass_warm_up(const ImagePass *pass, const Film *film);

/* Draws the sums of the group that `film` takes in next, for the pixels of these regions. The framebuffer
 * that is bound and the program in use change. */
void image_pass_draw(ImagePass *pass, const Film *film, const Rectangle *regions, int count, unsigned group);
