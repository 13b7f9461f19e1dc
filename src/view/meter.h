/* The light meter of the automatic exposure. It looks at the means of a picture's cells. */
#pragma once

#include "view/picture.h"

enum { METER_COLUMNS = 32, METER_ROWS = 18 };

typedef struct Meter {
    Target cells;
    /* What was measured last: the number of the picture, whether it was a preview, and its samples. */
    int picture;
    bool preview;
    uint64_t samples;
} Meter;

MUST_CHECK bool meter_create(Meter *meter, const Context *context, Error *error);
void meter_destroy(Meter *meter);

/* Measures the first side's picture, if there is a new one, and tells the automatic exposure. A picture at
 * rest is measured again whenever its samples have doubled, up to a number from where on it is known well
 * enough, so that its exposure does not depend on how long it was looked at. */
MUST_CHECK bool meter_follow(Meter *meter, const Display *display, const Picture *picture, ViewState *state,
                             Error *error);

/* The mean of the binary logarithm of the cells' luminance, and so in stops, without the brightest and the
 * darkest twentieth of the cells. The sun's own image is far brighter than all else and fills few cells, so
 * it does not count. A cell counts as no darker than ten stops below the brightest that is left. `rgba` has
 * four floats for each of METER_COLUMNS * METER_ROWS cells. NaN if the picture is black. */
double meter_reading(const float *rgba);
