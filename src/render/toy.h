/* A program that paints a picture by itself (scene/toy_source.h): a file that defines mainImage() or main()
 * and no scene. Each frame sees the one before as iChannel0; or if it has a Buffer A (scene/toy_tabs.h), what
 * that draws for the same frame, and Buffer A its own frame before. */
#pragma once

#include "gl/target.h"
#include "scene/scene.h"

#include <stdio.h>

/* What is wrong with pixels that toy_cut_share() counts. */
#define TOY_CUT_WORDS                                                                                        \
    "its loops turn more often than this OpenGL lets them: it ends all loops of a pixel after 65,535 turns " \
    "together, without an error, so that the picture is wrong there; take fewer steps, or an OpenGL of a "   \
    "GPU"

typedef struct Toy {
    /* Empty if the file is no such program. */
    Program program;
    Target target;
    /* Its Buffer A, which draws each frame first; NULL where there is none. Owned. */
    struct Toy *buffer;
    /* What the program does not get, a line each with its place; "" where there is nothing. Owned. */
    Text notes;
    /* The frame that is being drawn. The frame before is the target's front. */
    int frame;
    /* The next row of the frame. */
    int row;
    /* The measured speed. */
    double pixels_per_second;
    /* The moment of the frame that is being drawn. */
    struct ToyMoment {
        /* The frame's time, and the time since the frame before; seconds. */
        double time_s, delta_s;
        double mouse[4];
        /* Where in its pixel the sample lies, from the middle, in pixels. */
        double shift[3];
        /* iDate is that of the clock, and not the first day of 2000. */
        bool by_clock;
    } moment;
} Toy;

typedef struct ToyMoment ToyMoment;

/* Replaces the program by the file's, and keeps the frame before. `toy` may be empty. If it fails with
 * STATUS_SCENE and "file:line: ...", `toy` is unchanged. */
MUST_CHECK bool toy_compile(Toy *toy, const Context *context, const SceneFile *file, Error *error);
void toy_destroy(Toy *toy);

/* Sets the size. If the size changes, the program starts at its first frame. */
MUST_CHECK bool toy_resize(Toy *toy, const Context *context, int width, int height, Error *error);
void toy_restart(Toy *toy);

/* Draws for about `seconds`, or until `stop` returns true. A frame may take several calls. It keeps the
 * moment that it began with; `scene` has the values of its parameters. */
MUST_CHECK bool toy_draw(Toy *toy, const Scene *scene, const ToyMoment *moment, double seconds,
                         bool (*stop)(void), Error *error);

/* Returns the texture of the last complete frame. Its row 0 is at the bottom. */
GLuint toy_texture(const Toy *toy);

/* Prints what the program does not get, each as a warning. */
void toy_say_notes(const Toy *toy, FILE *out);

/* Sets `share` to the share of the last frame's pixels whose loops the driver has ended without a word. */
MUST_CHECK bool toy_cut_share(const Toy *toy, double *share, Error *error);
