#include "solid.h"
#include "random.h"
#include "support.h"

#include <math.h>
#include <stdio.h>

enum { WIDTH = 64, HEIGHT = 32, GRID = 40, NODES = GRID + 1, MOST_PATCHES = 72 };

static float inputs[8 * SOLID_ITEMS], results[8 * SOLID_ITEMS];
static const double PI2 = 6.283185307179586;

double place_distance2(Place a, Place b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
}

/* Solids of revolution about y: a place of the section's outline, turned. */
Place place_spun(double across, double height, double turn) {
    return (Place){across * cos(PI2 * turn), height, across * sin(PI2 * turn)};
}

double place_across(Place p) {
    return sqrt(p.x * p.x + p.z * p.z);
}

double place_mixed(double a, double b, double t) {
    return a + t * (b - a);
}

Place place_moved(Place at, double x, Place ex, double y, Place ey, double z, Place ez) {
    return (Place){at.x + x * ex.x + y * ey.x + z * ez.x, at.y + x * ex.y + y * ey.y + z * ez.y,
                   at.z + x * ex.z + y * ey.z + z * ez.z};
}

Place place_crossed(Place a, Place b) {
    return (Place){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Place place_united(Place a) {
    double size = sqrt(place_distance2(a, (Place){0, 0, 0}));
    return (Place){a.x / size, a.y / size, a.z / size};
}

/* A tube about the direction `along` at a place of its middle, and its round end. */
Place place_tube(Place at, Place along, double radius, double turn) {
    Place side = place_united(place_crossed(along, (Place){0.1, 0.2, 0.9})),
          other = place_crossed(along, side);
    return place_moved(at, radius * cos(PI2 * turn), side, radius * sin(PI2 * turn), other, 0, along);
}

Place place_tube_end(Place at, Place along, double radius, double u, double turn) {
    double out = radius * sin(PI2 / 4 * u);
    return place_tube(place_moved(at, 0, at, 0, at, radius * cos(PI2 / 4 * u), along), along, out, turn);
}

/* Moves the place (u, v) of a patch by (du, dv) if that is nearer to p. */
static bool step_nearer(const Solid *solid, Place p, int patch, double *u, double *v, double du, double dv,
                        double *best) {
    double s = fmin(fmax(*u + du, 0), 1), t = fmin(fmax(*v + dv, 0), 1);
    double d = place_distance2(p, solid->surface(patch, s, t));
    if (!(d < *best)) return false;
    *best = d, *u = s, *v = t;
    return true;
}

/* The least distance to a patch near the place (u, v), by ever smaller steps. At a tip, where all v are one
 * place, the way on may lie at any v. */
static double refined(const Solid *solid, Place p, int patch, double u, double v) {
    static const int way[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
    double best = place_distance2(p, solid->surface(patch, u, v));
    for (double step = 1.0 / GRID; step > 1e-8;) {
        bool nearer = false;
        for (int k = 0; k < 8 && !nearer; k++)
            nearer = step_nearer(solid, p, patch, &u, &v, step * way[k][0], step * way[k][1], &best);
        for (int k = 0; k <= 240 && !nearer && (u == 0 || u == 1); k++)
            nearer = step_nearer(solid, p, patch, &u, &v, u == 0 ? step : -step, k / 240.0 - v, &best);
        if (!nearer) step *= 0.5;
    }
    return sqrt(best);
}

/* The distance from p to the solid's surface, in its own frame. A search starts at the nearest node of each
 * quarter of each patch, if it may count. */
static double searched(const Solid *solid, Place nodes[][NODES * NODES], Place p) {
    double near[4 * MOST_PATCHES], least = 1e30, best = 1e30;
    int at[4 * MOST_PATCHES] = {0};
    for (int k = 0; k < 4 * solid->patches; k++) near[k] = 1e30;
    for (int patch = 0; patch < solid->patches; patch++) {
        for (int i = 0; i < NODES * NODES; i++) {
            double d = place_distance2(p, nodes[patch][i]);
            int k = 4 * patch + 2 * (i / NODES > GRID / 2) + (i % NODES > GRID / 2);
            if (d < near[k]) near[k] = d, at[k] = i;
        }
    }
    for (int k = 0; k < 4 * solid->patches; k++) near[k] = sqrt(near[k]), least = fmin(least, near[k]);
    for (int k = 0; k < 4 * solid->patches; k++) {
        double u = (double)(at[k] / NODES) / GRID, v = (double)(at[k] % NODES) / GRID;
        if (near[k] < least + 0.3) best = fmin(best, refined(solid, p, k / 4, u, v));
    }
    return best;
}

static Place into_frame(const Solid *solid, const float *item) {
    double s = (double)item[3];
    Place p = {(double)item[0] / s - 0.125, (double)item[1] / s + 0.25, (double)item[2] / s - 0.5};
    if (!solid->turned) return p;
    return (Place){0.8 * p.x - 0.6 * p.z, 0.48 * p.x + 0.6 * p.y + 0.64 * p.z,
                   -0.36 * p.x + 0.8 * p.y - 0.48 * p.z};
}

void solid_make_inputs(void) {
    static const double scales[] = {1, 1e-3, 1e4};
    random_state = 5;
    for (int i = 0; i < SOLID_ITEMS; i++) {
        double scale = scales[i % 3], reach = i / 3 % 2 ? 0.9 : 3;
        for (int c = 0; c < 3; c++) {
            inputs[8 * i + c] = (float)(reach * scale * (2 * random_unit() - 1));
            inputs[8 * i + 4 + c] = (float)(0.02 * scale * (2 * random_unit() - 1));
        }
        inputs[8 * i + 3] = (float)scale;
    }
}

void solid_evaluate(const Context *context, const Solid *solid, double size) {
    char glsl[4096];
    snprintf(glsl, sizeof glsl,
             "%s\nuniform sampler2D inputs;\n"
             "const vec3 C = vec3(0.125, -0.25, 0.5), N = vec3(0.48, 0.6, 0.64), E = vec3(0.8, 0.0, -0.6);\n"
             "float field(vec3 p, float s) { return %s; }\n"
             "vec4 evaluate(vec2 t) {\n    ivec2 at = ivec2(int(t.x) / 2 * 2, int(t.y));\n"
             "    vec4 a = texelFetch(inputs, at, 0), b = texelFetch(inputs, at + ivec2(1, 0), 0);\n"
             "    float s = a.w, d = field(a.xyz, s * float(%.9f));\n    vec3 q = a.xyz + b.xyz;\n"
             "    return vec4(d / s, (field(q, s * float(%.9f)) - d) / length(q - a.xyz), 0.0, 0.0);\n}\n",
             solid->includes, solid->expression, size, size);
    support_evaluate(context, glsl, inputs, WIDTH, HEIGHT, results);
}

SolidCompared solid_compare(const Solid *solid, int items) {
    static Place nodes[MOST_PATCHES][NODES * NODES];
    SolidCompared found = {0};
    for (int patch = 0; patch < solid->patches; patch++) {
        for (int i = 0; i < NODES * NODES; i++)
            nodes[patch][i] = solid->surface(patch, (double)(i / NODES) / GRID, (double)(i % NODES) / GRID);
    }
    for (int i = 0; i < items; i++) {
        Place p = into_frame(solid, inputs + 8 * i);
        double value = (double)results[8 * i];
        bool inside = solid->inside(p);
        found.inside += inside;
        found.steepest = fmax(found.steepest, fabs((double)results[8 * i + 1]));
        if (!isfinite(value)) found.worst = INFINITY;
        if (fabs(value) > 1e-5 && (value < 0) != inside) found.wrong_side++;
        if (inside && solid->outside_only) continue;
        found.worst = fmax(found.worst, fabs(fabs(value) - searched(solid, nodes, p)));
    }
    return found;
}

void solid_test_exact(const Context *context, const Solid *solids, int count, int items) {
    solid_make_inputs();
    for (int k = 0; k < count; k++) {
        solid_evaluate(context, &solids[k], 1);
        SolidCompared found = solid_compare(&solids[k], items);
        print_message("%s: %d of %d inside, %d on the wrong side, largest error %.1e, steepness to %.5f\n",
                      solids[k].name, found.inside, items, found.wrong_side, found.worst, found.steepest);
        assert_true(found.inside > 4 && found.wrong_side == 0 && found.worst < 3e-6 &&
                    found.steepest < 1.0005);
    }
}

void solid_test_wrong_size(const Context *context, const Solid *solids, int count) {
    solid_make_inputs();
    for (int k = 0; k < count; k++) {
        solid_evaluate(context, &solids[k], 1.001);
        assert_true(solid_compare(&solids[k], 48).worst > 1e-4);
    }
}
