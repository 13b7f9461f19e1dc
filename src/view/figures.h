/* What the overlay tells of the pictures. */
#pragma once

#include "view/state.h"

#include <stdint.h>

enum { MOST_CURVE = 160 };

/* The estimated error as the picture converged. */
typedef struct ErrorCurve {
    double seconds[MOST_CURVE], percent[MOST_CURVE];
    int count;
} ErrorCurve;

typedef struct SideFigures {
    char methods[192];    /* what was chosen */
    uint64_t samples;     /* a pixel; frames of a Shadertoy program */
    double error_percent; /* estimated; NaN while it is not known */
    double paths_per_second, seconds;
    int coarseness; /* pixels a side of one of the preview's; 1 at rest */
    ErrorCurve curve;
} SideFigures;

/* The pixel under the pointer; not known while things move. */
typedef struct PixelFigures {
    bool known;
    int x, y;
    int place; /* 0 where there is one picture, 1 on the left of two, 2 on the right */
    double radiance[3], samples, error_percent; /* standard error of the mean over it, by luminance */
    double albedo[3], depth, hits;
} PixelFigures;

typedef struct ViewFigures {
    SideFigures sides[MOST_SIDES];
    PixelFigures pixel;
    double frame_s; /* the last frame took */
    int width, height;
    double scale; /* pixels per unit of the window's coordinates */
    const char *gl_renderer;
    bool scene; /* whether there is one, or a Shadertoy program */
} ViewFigures;

/* Adds a point, if it is some way from the last. */
void curve_extend(ErrorCurve *curve, double seconds, double percent);

/* Where a point of at least two is drawn, 0 to 1 from the left and from the top. Both axes are logarithmic:
 * a straight line falls by half where the time quadruples. */
void curve_place(const ErrorCurve *curve, int point, double place[2]);

/* In words: "80 samples in 2.2 s"; "error about 1.04 %"; these with methods and speed, in three lines; a
 * pixel's, in five. */
void figures_progress(const SideFigures *side, char *text, size_t size);
void figures_error(const SideFigures *side, char *text, size_t size);
void figures_side(const SideFigures *side, char *text, size_t size);
void figures_pixel(const PixelFigures *pixel, char *text, size_t size);
