/* Draws a pass in pieces that take about a tenth of a second each. The pass can be stopped between pieces,
 * and no driver believes that a draw hangs.
 *
 * How long a pixel takes differs a hundredfold within a picture. A Pace therefore knows it by bands of rows.
 * Before the first drawing of a large picture, a few small blocks of pixels all over it are drawn and timed;
 * a small picture begins with a small piece. Later the pieces themselves are timed. A piece is whole rows
 * where its time allows that, and else a part of a row. The pieces of a pass do not change its picture. */
#pragma once

#include "base/rectangle.h"
#include "gl/program.h"

enum { PACE_BANDS = 64 };

typedef struct Pace {
    /* The picture's size for which it is known; 0 if for none. */
    int width, height;
    /* Seconds that a sample of a pixel takes, by bands of rows: on average, and at worst. */
    double mean[PACE_BANDS], worst[PACE_BANDS];
    /* The longest draw so far, in seconds, and how many there were. */
    double longest_s;
    long draws;
} Pace;

/* A pass over parts of a picture. */
typedef struct Strips {
    /* It must be in use. */
    const Program *program;
    Rectangle picture;
    const Rectangle *regions;
    int count;
    /* Samples of each pixel that it takes. */
    unsigned samples;
    /* May be NULL. It is called between pieces. */
    bool (*stop)(void);
} Strips;

/* Draws the regions of the bound framebuffer, and waits until it is done. Returns false if `stop` returned
 * true before the end; then some pixels behind the last piece may be drawn, too. */
bool strips_draw(const Strips *strips, Pace *pace);

/* Sets the pace of a picture of this size: seconds that a sample of a pixel takes. */
void pace_set(Pace *pace, int width, int height, double seconds);

/* Draws rows of [0, width) x [0, height) for about `seconds`, from *row on and at least two rows. Sets *row
 * to the next row. A strip takes about a third of the time and not more than a tenth of a second, because
 * some rows of a picture take several times as long as others. `pixels_per_second` is a guess, and is set to
 * the measured speed. `stop` may be NULL. */
void strips_draw_for(const Program *program, int width, int height, int *row, double *pixels_per_second,
                     double seconds, bool (*stop)(void));
