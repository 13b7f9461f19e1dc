#include "render/aim.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* The rectangle is wider than the places on each side, and paths begin higher, by these parts of their
 * extent: they are samples, and a surface reaches farther than its samples. */
static const double margin = 0.1, headroom = 0.5;

/* The rectangle leaves out this part of the places on each side, which may be as far as the horizon. */
static const double left_out = 0.002;

/* A node with fewer places is cut in the middle, so that single places do not draw all light paths. */
enum { FEWEST_PLACES = 8 };

/* A path that brought more than so many times the mean counts as if it had brought that much. */
static const double most_light = 8;

/* A part must not be thinner than this share of the node that it is cut from, and not so thin that a float of
 * its coordinates has no digits for it: these are shares of the largest coordinate, for a part and for the
 * rectangle. */
static const double thinnest = 0.02, thinnest_part = 4e-6, thinnest_rectangle = 4e-4;

typedef struct Place {
    double at[2], light;
} Place;

static int by_first(const void *a, const void *b) {
    const Place *p = a, *q = b;
    return p->at[0] != q->at[0] ? (p->at[0] > q->at[0]) - (p->at[0] < q->at[0])
                                : (p->at[1] > q->at[1]) - (p->at[1] < q->at[1]);
}

static int by_second(const void *a, const void *b) {
    const Place *p = a, *q = b;
    return p->at[1] != q->at[1] ? (p->at[1] > q->at[1]) - (p->at[1] < q->at[1])
                                : (p->at[0] > q->at[0]) - (p->at[0] < q->at[0]);
}

/* Where the light of these places, in their order along the axis, is cut in two equal parts. */
static double middle_of_light(const Place *places, int count, int axis) {
    double all = 0, passed = 0;
    for (int i = 0; i < count; i++) all += places[i].light;
    for (int i = 0; i < count; i++) {
        passed += places[i].light;
        if (passed >= all / 2) return places[i].at[axis];
    }
    return places[count - 1].at[axis];
}

/* A box and the places in it. */
typedef struct Box {
    double sides[4];
    Place *places;
    int count;
    /* Parts must not be thinner than this. */
    double least;
} Box;

typedef struct Halves {
    float where;
    int axis;
    Box box[2];
} Halves;

/* Cuts a box across its longer side. */
static Halves cut(const Box *box) {
    double sides[2] = {box->sides[2] - box->sides[0], box->sides[3] - box->sides[1]};
    int axis = sides[1] > sides[0], before = 0;
    double low = box->sides[axis], at = low + sides[axis] / 2;
    double thin = fmin(fmax(thinnest * sides[axis], box->least), sides[axis] / 2);
    qsort(box->places, (size_t)box->count, sizeof *box->places, axis ? by_second : by_first);
    if (box->count >= FEWEST_PLACES) at = middle_of_light(box->places, box->count, axis);
    Halves halves = {(float)fmin(fmax(at, low + thin), low + sides[axis] - thin), axis, {*box, *box}};
    double where = (double)halves.where;
    while (before < box->count && box->places[before].at[axis] < where) before++;
    halves.box[0].sides[axis + 2] = halves.box[1].sides[axis] = where;
    halves.box[0].count = before;
    halves.box[1].places += before;
    halves.box[1].count -= before;
    return halves;
}

static void make_node(Aim *aim, int node, const Box *box) {
    if (node >= AIM_NODES) return;
    Halves first = cut(box);
    float *texel = aim->nodes[node];
    texel[0] = first.where;
    int axes = first.axis;
    for (int i = 0; i < 2; i++) {
        Halves second = cut(&first.box[i]);
        texel[1 + i] = second.where;
        axes += second.axis << (1 + i);
        for (int k = 0; k < 2; k++) make_node(aim, 4 * node + 1 + 2 * i + k, &second.box[k]);
    }
    texel[3] = (float)axes;
}

static double largest(const double box[4]) {
    return fmax(fmax(fabs(box[0]), fabs(box[1])), fmax(fabs(box[2]), fabs(box[3])));
}

/* Makes the tree. The places' order changes. */
static void make_tree(Aim *aim, Place *places, int count) {
    double mean = 0;
    Box all = {{aim->box[0], aim->box[1], aim->box[2], aim->box[3]},
               places,
               count,
               thinnest_part * largest(aim->box)};
    for (int i = 0; i < count; i++) mean += places[i].light / count;
    for (int i = 0; i < count; i++) places[i].light = fmin(places[i].light, most_light * mean);
    make_node(aim, 0, &all);
}

static int by_value(const void *a, const void *b) {
    const double *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}

/* The values between which all but `left_out` of the coordinates on either side are, and the middle one. */
typedef struct Range {
    double low, middle, high;
} Range;

static Range range_of(double *values, int count) {
    int out = (int)(left_out * count);
    qsort(values, (size_t)count, sizeof *values, by_value);
    return (Range){values[out], values[count / 2], values[count - 1 - out]};
}

/* Sets the rectangle, the plane and where paths begin. */
static void frame(Aim *aim, const Range range[3], double spread) {
    double extent = 1e-3, corners[4] = {range[0].low, range[1].low, range[0].high, range[1].high};
    for (int k = 0; k < 3; k++) extent = fmax(extent, range[k].high - range[k].low);
    aim->plane = range[2].middle;
    aim->top = range[2].high + headroom * extent;
    double off = fmax(range[2].high - aim->plane, aim->plane - range[2].low);
    double wider = fmax(margin * extent + spread * off, thinnest_rectangle * largest(corners));
    for (int k = 0; k < 4; k++) aim->box[k] = (double)(float)(corners[k] + (k < 2 ? -wider : wider));
}

void aim_begin(Aim *aim, const float *places, int count, double spread) {
    Place *found = memory_get((size_t)count + 1, sizeof *found);
    double *values = memory_get((size_t)count + 1, 3 * sizeof *values);
    int used = 0;
    *aim = (Aim){0};
    for (int i = 0; i < count; i++) {
        const float *p = places + 4 * i;
        if (!(p[3] > 0) || !isfinite(p[0]) || !isfinite(p[1]) || !isfinite(p[2])) continue;
        for (int k = 0; k < 3; k++) values[k * count + used] = (double)p[k];
        found[used++] = (Place){{(double)p[0], (double)p[1]}, 1};
    }
    aim->any = used > 0;
    if (aim->any) {
        Range range[3];
        for (int k = 0; k < 3; k++) range[k] = range_of(values + k * count, used);
        frame(aim, range, spread);
        make_tree(aim, found, used);
    }
    free(found);
    free(values);
}

void aim_improve(Aim *aim, const float *starts, int count) {
    Place *found = memory_get((size_t)count + 1, sizeof *found);
    int used = 0;
    for (int i = 0; i < count; i++) {
        const float *p = starts + 4 * i;
        if (p[3] > 0 && isfinite(p[3])) found[used++] = (Place){{(double)p[0], (double)p[1]}, (double)p[3]};
    }
    aim->any = used > 0;
    if (aim->any) make_tree(aim, found, used);
    free(found);
}
