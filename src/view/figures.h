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
