#include "view/meter.h"

#include <math.h>
#include <stdlib.h>

enum { CELLS = METER_COLUMNS * METER_ROWS, LEFT_OUT = CELLS / 20 };

static const uint64_t enough_samples = 64;

bool meter_create(Meter *meter, const Context *context, Error *error) {
    return target_create(&meter->cells, context, METER_COLUMNS, METER_ROWS, 1, error);
}

void meter_destroy(Meter *meter) {
    target_destroy(&meter->cells);
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double meter_reading(const float *rgba) {
    double cells[CELLS], sum = 0;
    for (int i = 0; i < CELLS; i++) {
        const float *rgb = rgba + 4 * (size_t)i;
        double light = 0.2126 * (double)rgb[0] + 0.7152 * (double)rgb[1] + 0.0722 * (double)rgb[2];
        cells[i] = light > 0 && light < INFINITY ? light : 0;
    }
    qsort(cells, CELLS, sizeof *cells, by_size);
    double brightest = cells[CELLS - 1 - LEFT_OUT];
    if (!(brightest > 0)) return NAN;
    for (int i = LEFT_OUT; i < CELLS - LEFT_OUT; i++) sum += log2(fmax(cells[i], brightest / 1024));
    return sum / (CELLS - 2 * LEFT_OUT);
}

static bool read_cells(Meter *meter, const Display *display, const Film *film, double *reading,
                       Error *error) {
    float rgba[4 * CELLS];
    display_cells(display, film, &meter->cells);
    target_swap(&meter->cells);
    if (!target_read(&meter->cells, 0, rgba, error)) return false;
    *reading = meter_reading(rgba);
    return true;
}

bool meter_follow(Meter *meter, const Display *display, const Picture *picture, ViewState *state,
                  Error *error) {
    const Pane *pane = &picture->panes[0];
    const Film *film = &pane->renderer.film;
    bool preview = pane->preview_samples > 0, doubled = !(film->samples & (film->samples - 1));
    double reading;
    if (!pane->renderer.gl || !pane_is_ready(pane) || !film->samples) return true;
    bool known = meter->picture == picture->pictures && meter->preview == preview && meter->samples;
    if (known && (meter->samples == film->samples || film->samples > enough_samples || !doubled)) return true;
    if (!read_cells(meter, display, film, &reading, error)) return false;
    meter->picture = picture->pictures;
    meter->preview = preview;
    meter->samples = film->samples;
    exposure_read(&state->exposure, &pane->scene.values, reading);
    return true;
}
