#include "chart/pareto.h"

#include <math.h>

double pareto_seconds(const ParetoCurve *curve, double percent) {
    for (int i = 0; i < curve->count; i++) {
        const ParetoPoint *b = &curve->points[i], *a = b - 1;
        if (!(b->percent <= percent)) continue;
        if (i == 0) return b->seconds;
        double share = log(a->percent / percent) / log(a->percent / b->percent);
        return a->seconds * pow(b->seconds / a->seconds, share);
    }
    return INFINITY;
}

int pareto_front(const ParetoCurve *curves, int count, ParetoPoint *front, int most) {
    double first = INFINITY, worst = 0, best = INFINITY;
    for (int c = 0; c < count; c++) {
        for (int i = 0; i < curves[c].count; i++) {
            const ParetoPoint *point = &curves[c].points[i];
            if (point->seconds < first) first = point->seconds, worst = point->percent;
            best = fmin(best, point->percent);
        }
    }
    if (!(worst > 0)) return 0;
    for (int i = 0; i < most; i++) {
        /* The last error is taken a little larger, because rounding could miss the curve's last point. */
        double percent = worst * pow(best / worst, (double)i / (most - 1)) * (1 + 1e-9);
        front[i] = (ParetoPoint){INFINITY, percent};
        for (int c = 0; c < count; c++)
            front[i].seconds = fmin(front[i].seconds, pareto_seconds(&curves[c], percent));
    }
    return most;
}
