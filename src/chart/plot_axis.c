#include "chart/plot_axis.h"

#include <math.h>
#include <stdio.h>

void plot_axis_include(PlotAxis *axis, double value) {
    if (!(value > 0) || !isfinite(value)) return;
    axis->low = axis->low > 0 ? fmin(axis->low, value) : value;
    axis->high = fmax(axis->high, value);
}

/* Returns the largest number that is 1, 2 or 5 times a power of ten and at most `value`. */
static double step_below(double value) {
    double ten = pow(10, floor(log10(value) + 1e-9)), digit = value / ten * (1 + 1e-9);
    return ten * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

static double step_above(double value) {
    double step = step_below(value), ten = pow(10, floor(log10(value) + 1e-9));
    return step >= value * (1 - 1e-9) ? step
           : step < 1.5 * ten         ? 2 * ten
           : step < 3 * ten           ? 5 * ten
                                      : 10 * ten;
}

void plot_axis_finish(PlotAxis *axis) {
    if (!(axis->low > 0)) *axis = (PlotAxis){1, 10};
    axis->low = step_below(axis->low / 1.15);
    axis->high = step_above(axis->high * 1.15);
}

double plot_axis_at(const PlotAxis *axis, double value) {
    return log(value / axis->low) / log(axis->high / axis->low);
}

static void write_label(PlotTick *tick) {
    double v = tick->value;
    if (v >= 0.999e6 && v < 1e9) {
        snprintf(tick->label, sizeof tick->label, "%gM", v / 1e6);
    } else if (v >= 0.999e4 && v < 1e6) {
        snprintf(tick->label, sizeof tick->label, "%gk", v / 1e3);
    } else {
        snprintf(tick->label, sizeof tick->label, "%.6g", v);
    }
}

int plot_axis_ticks(const PlotAxis *axis, PlotTick ticks[PLOT_TICKS]) {
    double span = log10(axis->high / axis->low);
    int count = 0, first = (int)floor(log10(axis->low) + 1e-9);
    for (int i = 0; count < PLOT_TICKS; i++) {
        int digit = i % 9 + 1, power = first + i / 9;
        /* Division gives exactly the number that 0.001 means; multiplication by 10^-3 might not. */
        double value = power < 0 ? digit / pow(10, -power) : digit * pow(10, power);
        if (value > axis->high * (1 + 1e-9)) break;
        if (value < axis->low * (1 - 1e-9)) continue;
        PlotTick *tick = &ticks[count++];
        *tick = (PlotTick){.value = value, .strong = digit == 1};
        bool named = digit == 1 ? span <= 7 || power % 2 == 0 : (digit == 2 || digit == 5) && span <= 3.3;
        if (named) write_label(tick);
    }
    return count;
}
