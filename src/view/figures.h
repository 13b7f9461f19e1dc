/* The figures that the overlay shows about the pictures. */
#pragma once

#include "view/menu.h"
#include "view/state.h"

#include <stdint.h>

enum { MOST_CURVE = 160, MOST_WRONG = 512 };

/* The estimated error against time, while the picture converged. */
typedef struct ErrorCurve {
    double seconds[MOST_CURVE], percent[MOST_CURVE];
    int count;
} ErrorCurve;

typedef struct SideFigures {
    /* The names of the methods in use. */
    char methods[208];
    /* Samples of each pixel, or frames of a Shadertoy program. */
    uint64_t samples;
    /* The estimated error. NaN while it is not known. */
    double error_percent;
    /* The same in 8-bit levels of the picture as it is shown: the RMS, and that of the worst 16x16 tile. */
    double error_levels, worst_levels;
    /* The share of the picture's light that is found only by luck, percent; the error may leave it out. 0 if
     * there is none. */
    double chance_percent;
    double paths_per_second, seconds;
    /* The part of the sky's tables that is ready. Before it is 1 the picture of before is shown. */
    double prepared;
    /* How long they have been waited for. */
    double waited_s;
    /* The side of a preview's pixel, in pixels of the picture. 1 if the picture is at rest. */
    int coarseness;
    ErrorCurve curve;
    /* What is wrong with the scene's values, in lines; empty if nothing was found. */
    char wrong[MOST_WRONG];
} SideFigures;

/* The pixel under the pointer. It is not known while something moves. */
typedef struct PixelFigures {
    bool known;
    int x, y;
    /* 0 if there is one picture; 1 on the left of two pictures, 2 on the right. */
    int place;
    /* The error is the standard error of the mean, relative to the mean, by luminance. */
    double radiance[3], samples, error_percent;
    double albedo[3], depth, hits;
} PixelFigures;

typedef struct ViewFigures {
    SideFigures sides[MOST_SIDES];
    PixelFigures pixel;
    /* How long the last frame took, and the last few in the mean. */
    double frame_s, frame_mean_s;
    int width, height;
    /* Pixels per unit of the window's coordinates. */
    double scale;
    const char *gl_renderer;
    const SceneMenu *menu;
    /* False if a Shadertoy program is shown in place of a scene. */
    bool scene;
} ViewFigures;

/* Adds a point, if it is far enough from the last one. */
void curve_extend(ErrorCurve *curve, double seconds, double percent);

/* Sets `place` to where a point is drawn, from 0 to 1 from the left and from the top. The curve has at least
 * two points. Both axes are logarithmic. The error of independent samples, which halves when the time
 * quadruples, is a straight line. */
void curve_place(const ErrorCurve *curve, int point, double place[2]);

/* Prints "80 samples in 2.2 s", or "computing the sky, 40 %". */
void figures_progress(const SideFigures *side, char *text, size_t size);

/* Prints "error about 1.04 %". */
void figures_error(const SideFigures *side, char *text, size_t size);

/* Prints "2.3 of 255 levels, 5.1 in the worst tile", or nothing. */
void figures_levels(const SideFigures *side, char *text, size_t size);

/* Prints progress, error, methods and speed of a side in three lines or four. */
void figures_side(const SideFigures *side, char *text, size_t size);

/* Prints "24 fps  80 samples in 2.2 s  1.04 %  sun 30 0", as far as it has no more than this number of
 * characters. The less important is left out first. */
void figures_bar(const ViewFigures *figures, const Sun *sun, int most, char *text, size_t size);

/* Prints the figures of a pixel in five lines. */
void figures_pixel(const PixelFigures *pixel, char *text, size_t size);
