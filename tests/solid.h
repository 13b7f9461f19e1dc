/* Solids said by patches of their surfaces, and distance fields in GLSL compared with a search over these in
 * double precision.
 */
#pragma once

#include "gl/context.h"

#include <stdbool.h>

enum { SOLID_ITEMS = 1024 };

typedef struct Place {
    double x, y, z;
} Place;

/* A solid in its own frame: patches of its surface with u and v from 0 to 1, and what is inside. */
typedef struct Solid {
    /* `expression` is its distance in GLSL by p, s (by which all lengths are multiplied), the centre C, and
     * the directions N and E. */
    const char *includes, *name, *expression;
    Place (*surface)(int patch, double u, double v);
    int patches;
    bool (*inside)(Place p);
    /* Its y is the axis N, and its x the direction E. */
    bool turned;
    /* It is exact only there. */
    bool outside_only;
} Solid;

/* `worst` is in units of s. */
typedef struct SolidCompared {
    int inside, wrong_side;
    double worst, steepest;
} SolidCompared;

/* Random points about C at three scales. */
void solid_make_inputs(void);

/* The field at the points, with all lengths of the solid multiplied by `size`. */
void solid_evaluate(const Context *context, const Solid *solid, double size);

/* What was evaluated, beside the search, for the first `items` points. */
SolidCompared solid_compare(const Solid *solid, int items);

/* Asserts that the fields of `count` solids are as far as the search finds at the first `items` points, on
 * the right side, and never steeper than a metre a metre. */
void solid_test_exact(const Context *context, const Solid *solids, int count, int items);

/* Asserts that the comparison sees each solid whose lengths are a thousandth too large. */
void solid_test_wrong_size(const Context *context, const Solid *solids, int count);

double place_distance2(Place a, Place b);
double place_across(Place p);
double place_mixed(double a, double b, double t);
Place place_crossed(Place a, Place b);
Place place_united(Place a);
/* at + x ex + y ey + z ez */
Place place_moved(Place at, double x, Place ex, double y, Place ey, double z, Place ez);
/* A place of a section's outline, turned about y. */
Place place_spun(double across, double height, double turn);
/* A tube about the direction `along` at a place of its middle, and its round end. */
Place place_tube(Place at, Place along, double radius, double turn);
Place place_tube_end(Place at, Place along, double radius, double u, double turn);
