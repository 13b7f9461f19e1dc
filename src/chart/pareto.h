/* Finds the quickest method for each error, from points and curves of percent against seconds. */
#pragma once

typedef struct ParetoPoint {
    double seconds, percent;
} ParetoPoint;

/* The points are in the order of time. */
typedef struct ParetoCurve {
    const ParetoPoint *points;
    int count;
} ParetoCurve;

/* Returns the time at which a curve first reaches this error. The curve is straight between its points on
 * logarithmic axes. Returns INFINITY if it never reaches the error, and the time of its first point if it
 * starts below. */
double pareto_seconds(const ParetoCurve *curve, double percent);

/* Computes the front: the least time of all curves for each of `most` errors. The errors are evenly spaced on
 * a logarithmic axis, from that of the quickest point to the least of all. Returns the number of points of
 * the front, which is 0 if there are no curves. */
int pareto_front(const ParetoCurve *curves, int count, ParetoPoint *front, int most);
