#include "render/aim.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* The rectangle is wider than the places on each side, and the plane is higher, by these parts of their
 * extent: they are samples, and a surface reaches farther than its samples. */
static const double margin = 0.1, headroom = 0.5;

/* A node with fewer places is cut in the middle, so that single places do not draw all light paths. */
enum { FEWEST_PLACES = 8 };

/* A path that brought more than so many times the mean counts as if it had brought that much. */
static const double most_light = 8;

/* A part must not be thinner than this share of the node that it is cut from. */
static const double thinnest = 0.02;

typedef struct Place {
    double at[2], light;
} Place;

typedef struct Tree {
    Aim *aim;
    Place *places;
} Tree;

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

/* Cuts the node across the longer side of its box. */
static void cut(const Tree *tree, int node, int first, int count, const double box[4]) {
    if (node >= AIM_NODES) return;
    Place *places = tree->places + first;
    double sides[2] = {box[2] - box[0], box[3] - box[1]};
    int axis = sides[1] > sides[0], before = 0;
    double at = box[axis] + sides[axis] / 2, thin = thinnest * sides[axis];
    qsort(places, (size_t)count, sizeof *places, axis ? by_second : by_first);
    if (count >= FEWEST_PLACES) at = middle_of_light(places, count, axis);
    float where = (float)fmin(fmax(at, box[axis] + thin), box[axis + 2] - thin);
    tree->aim->nodes[node][0] = where;
    tree->aim->nodes[node][1] = (float)axis;
    while (before < count && places[before].at[axis] < (double)where) before++;
    double low[4] = {box[0], box[1], box[2], box[3]}, high[4] = {box[0], box[1], box[2], box[3]};
    low[axis + 2] = high[axis] = (double)where;
    cut(tree, 2 * node, first, before, low);
    cut(tree, 2 * node + 1, first + before, count - before, high);
}

/* Makes the tree. The places' order changes. */
static void make_tree(Aim *aim, Place *places, int count) {
    double mean = 0;
    Tree tree = {aim, places};
    for (int i = 0; i < count; i++) mean += places[i].light / count;
    for (int i = 0; i < count; i++) places[i].light = fmin(places[i].light, most_light * mean);
    cut(&tree, 1, 0, count, aim->box);
}

void aim_begin(Aim *aim, const float *places, int count, double spread) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    Place *found = memory_get((size_t)count + 1, sizeof *found);
    int used = 0;
    *aim = (Aim){0};
    for (int i = 0; i < count; i++) {
        const float *p = places + 4 * i;
        if (!(p[3] > 0) || !isfinite(p[0]) || !isfinite(p[1]) || !isfinite(p[2])) continue;
        for (int k = 0; k < 3; k++)
            low[k] = fmin(low[k], (double)p[k]), high[k] = fmax(high[k], (double)p[k]);
        found[used++] = (Place){{(double)p[0], (double)p[1]}, 1};
    }
    aim->any = used > 0;
    if (aim->any) {
        double extent = fmax(fmax(high[0] - low[0], high[1] - low[1]), fmax(high[2] - low[2], 1e-3));
        aim->top = high[2] + headroom * extent;
        double wider = margin * extent + spread * (aim->top - low[2]);
        for (int k = 0; k < 2; k++) {
            aim->box[k] = (double)(float)(low[k] - wider);
            aim->box[k + 2] = (double)(float)(high[k] + wider);
        }
        make_tree(aim, found, used);
    }
    free(found);
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
