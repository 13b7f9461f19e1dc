/* Where two pictures differ: in false colours beside a scale, and beside the pictures themselves. */
#pragma once

#include "image/image.h"
#include "image/tone.h"

typedef struct DifferenceParams {
    /* They have the same size. */
    const Image *a, *b;
    /* One byte a pixel: 0 where the pictures are not compared. */
    const unsigned char *compared;
    /* How the pictures are shown. */
    Tone tone;
    double exposure_ev;
} DifferenceParams;

/* The root mean square difference of the pixel's channels in 8-bit levels, as the pictures are shown. It is
 * negative where `a` is darker in the mean of the channels. */
double difference_at(const DifferenceParams *params, int x, int y);

/* The difference at the ends of the scale: the least of 1, 2, 5, 10, 20, 50, 100 and 255 that 99 % of the
 * compared pixels do not exceed. */
double difference_range(const DifferenceParams *params);

/* A picture as it is shown (Image.shown): the difference with its scale to the right. Grey is no difference,
 * red is where `a` is brighter, blue where it is darker; black pixels are not compared, and yellow ones are
 * not finite. */
Image difference_picture(const DifferenceParams *params);

/* The same, with `a` and `b` to the left of it. */
Image difference_side_by_side(const DifferenceParams *params);
