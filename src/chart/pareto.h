/* What is quickest at which error: points and curves in the plane of seconds against percent. */
#pragma once

typedef struct ParetoPoint {
    double seconds, percent;
} ParetoPoint;

/* In the order of time. */
typedef struct ParetoCurve {
    const ParetoPoint *points;
    int count;
} ParetoCurve;

/* When a curve first comes down to this error, straight between its points on logarithmic axes. Infinite if
 * it never does; its first point's time if it starts below. */
double pareto_seconds(const ParetoCurve *curve, double percent);

/* The least time of all curves at each error, at `most` errors from the worst that the quickest point has to
 * the best of all, evenly on a logarithmic axis. Gives the number of points: 0 where there are none. */
int pareto_front(const ParetoCurve *curves, int count, ParetoPoint *front, int most);
