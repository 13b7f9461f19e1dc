/* Exact shapes on the GPU: what they hit lies on them, nothing solid lies before it, and normals are theirs.
 */
#include "random.h"
#include "support.h"

#include <math.h>
#include <stdio.h>

enum { RAYS = 64 * 64 };

static float inputs[8 * RAYS], results[8 * RAYS];

/* Rays in pairs of texels, origin and direction; half of them aimed near the sphere, some skimming it. */
static void make_rays(double scale, double lowest, const double centre[3], double radius) {
    random_state = 7;
    for (int i = 0; i < RAYS; i++) {
        float *origin = inputs + 8 * i, *direction = origin + 4;
        double length = 0, target[3], v[3];
        for (int c = 0; c < 3; c++) {
            origin[c] = (float)(scale * (2 * random_unit() - 1));
            target[c] = centre[c] + (i % 2 ? 1.2 : 8) * radius * (2 * random_unit() - 1);
        }
        if ((double)origin[1] < lowest) origin[1] = (float)(lowest - (double)origin[1]);
        for (int c = 0; c < 3; c++) v[c] = target[c] - (double)origin[c], length += v[c] * v[c];
        for (int c = 0; c < 3; c++) direction[c] = (float)(v[c] / sqrt(length));
    }
}

/* Results in pairs of texels: (t, object, 0, 0), normal. `call` adds hits to `hit`; s is the fourth number
 * of the ray's origin. */
static void shoot(const Context *context, const char *file, const char *call) {
    char glsl[2048];
    snprintf(
        glsl, sizeof glsl,
        "#include \"%s\"\nuniform sampler2D inputs;\n"
        "vec4 evaluate(vec2 t) {\n"
        "    ivec2 at = ivec2(int(t.x) / 2 * 2, int(t.y));\n"
        "    Ray ray = Ray(texelFetch(inputs, at, 0).xyz, texelFetch(inputs, at + ivec2(1, 0), 0).xyz);\n"
        "    float s = texelFetch(inputs, at, 0).w;\n"
        "    Hit hit = hit_none();\n    %s\n"
        "    return int(t.x) %% 2 == 0 ? vec4(hit.t, float(hit.object), 0, 0) : vec4(hit.normal, 0);\n}",
        file, call);
    support_evaluate(context, glsl, inputs, 128, 64, results);
}

static void point_at(int ray, double t, double out[3]) {
    for (int c = 0; c < 3; c++) out[c] = (double)inputs[8 * ray + c] + t * (double)inputs[8 * ray + 4 + c];
}

static double distance(const double a[3], const double b[3]) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static void test_sphere(void **state) {
    (void)state;
    /* From millimetres to kilometres, near and far. */
    static const struct {
        double centre[3], radius, scale;
    } cases[] = {{{1, 2, 3}, 1.5, 10},
                 {{0, 0, 0}, 1, 0.9},
                 {{0.1, 0, 0}, 1e-3, 0.1},
                 {{100, 0, 0}, 0.5, 100},
                 {{0, -1e4, 0}, 1e4, 50}};
    Context context;
    support_open(&context);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        double radius = cases[k].radius;
        const double *centre = cases[k].centre;
        char call[256];
        int hits = 0;
        make_rays(cases[k].scale, -1e30, centre, radius);
        snprintf(call, sizeof call, "hit_sphere(ray, vec3(%.9f, %.9f, %.9f), %.9f, 5, hit);", centre[0],
                 centre[1], centre[2], radius);
        shoot(&context, "shape/sphere.glsl", call);
        for (int i = 0; i < RAYS; i++) {
            double o[3], b = 0, c, p[3], t = (double)results[8 * i];
            point_at(i, 0, o);
            for (int n = 0; n < 3; n++) b += (centre[n] - o[n]) * (double)inputs[8 * i + 4 + n];
            double reach = distance(o, centre), size = reach + radius;
            c = reach * reach - b * b; /* squared distance of the ray from the centre */
            if (fabs(sqrt(fmax(c, 0)) - radius) < 1e-6 * size || fabs(reach - radius) < 1e-6 * size) continue;
            double half = sqrt(fmax(radius * radius - c, 0));
            double expected = c > radius * radius || b + half < 0 ? 1e30 : b > half ? b - half : b + half;
            if (fabs(b - half) < 1e-6 * size) continue;
            if (expected > 1e29) {
                assert_true(t > 1e29);
                continue;
            }
            hits++;
            assert_true(t < 1e29 && results[8 * i + 1] == 5);
            point_at(i, t, p);
            if (fabs(distance(p, centre) - radius) > 2e-6 * (size + t)) {
                fail_msg("case %zu: %g off the surface", k, distance(p, centre) - radius);
            }
            double cosine = 0;
            for (int n = 0; n < 3; n++)
                cosine += (double)results[8 * i + 4 + n] * (p[n] - centre[n]) / radius;
            assert_true(fabs(cosine - 1) < 1e-4 + 4e-6 * size / radius);
        }
        assert_true(hits > RAYS / 10);
    }
    context_close(&context);
}

static void test_plane(void **state) {
    (void)state;
    static const double up[3] = {0, 0, 0};
    Context context;
    support_open(&context);
    make_rays(10, -1e30, up, 1);
    shoot(&context, "shape/plane.glsl", "hit_plane(ray, vec3(0, 0.6, 0.8), 1.0, 2, hit);");
    for (int i = 0; i < RAYS; i++) {
        const float *o = inputs + 8 * i, *d = o + 4;
        double height = 0.6 * (double)o[1] + 0.8 * (double)o[2] - 1,
               slope = 0.6 * (double)d[1] + 0.8 * (double)d[2];
        double expected = -height / slope, t = (double)results[8 * i];
        if (fabs(height) < 1e-5 || fabs(slope) < 1e-6) continue;
        if (expected < 0) assert_true(t > 1e29);
        if (expected > 0) assert_true(fabs(height + t * slope) < 1e-6 * (10 + t));
    }
    context_close(&context);
}

/* Solid where y < 0 outside of the sphere about (0, 0.3, 0) of radius 2: the bowl's rim is at x^2 + z^2
 * = 3.91. */
static double solid_distance(const double p[3]) {
    static const double centre[3] = {0, 0.3, 0};
    double below = -p[1], outside = distance(p, centre) - 2;
    return fmin(below, outside); /* > 0 in the solid, about the distance to its surface near it */
}

static void test_plane_minus_sphere(void **state) {
    (void)state;
    static const double origin[3] = {0, -0.3, 0};
    Context context;
    int plane = 0, bowl = 0;
    support_open(&context);
    for (int scale = 0; scale < 2; scale++) {
        make_rays(scale ? 1.3 : 20, scale ? -1.2 : 1e-3, origin, 2);
        shoot(&context, "shape/plane_minus_sphere.glsl",
              "hit_plane_minus_sphere(ray, vec3(0, 1, 0), 0.0, vec3(0, 0.3, 0), 2.0, 1, hit);");
        for (int i = 0; i < RAYS; i++) {
            double p[3], t = (double)results[8 * i], size;
            point_at(i, 0, p);
            if (solid_distance(p) > -1e-4) continue; /* starts in the solid: not promised */
            size = fmin(t, 60);
            for (int k = 1; k < 400; k++) {
                point_at(i, size * k / 400, p);
                if (solid_distance(p) > 1e-5 * (1 + size)) {
                    fail_msg("ray %d passes through the solid at %g of %g", i, size * k / 400, t);
                }
            }
            if (t > 1e29) continue;
            point_at(i, t, p);
            assert_true(fabs(solid_distance(p)) < 1e-5 * (1 + t));
            const float *n = results + 8 * i + 4;
            bool flat = n[1] > 0.999999f;
            plane += flat;
            bowl += !flat;
            double cosine =
                flat ? 1 : -((double)n[0] * p[0] + (double)n[1] * (p[1] - 0.3) + (double)n[2] * p[2]) / 2;
            assert_true(fabs(cosine - 1) < 1e-5 * (1 + t));
        }
    }
    assert_true(plane > 500 && bowl > 500);
    context_close(&context);
}

/* No ray from above slips between plane and bowl, aimed at the rim to the last bit. */
static void test_rim(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    for (int i = 0; i < RAYS; i++) {
        float *origin = inputs + 8 * i, *direction = origin + 4;
        double around = i * 0.01, length = 0, v[3];
        origin[0] = 0.3f, origin[1] = (float)(0.001 + 3 * fabs(sin(i * 1.7))), origin[2] = -4;
        const double rim[3] = {2 * sin(around), 0, 2 * cos(around)};
        for (int c = 0; c < 3; c++) v[c] = rim[c] - (double)origin[c], length += v[c] * v[c];
        for (int c = 0; c < 3; c++) direction[c] = (float)(v[c] / sqrt(length));
    }
    shoot(&context, "shape/plane_minus_sphere.glsl",
          "hit_plane_minus_sphere(ray, vec3(0, 1, 0), 0.0, vec3(0), 2.0, 1, hit);");
    for (int i = 0; i < RAYS; i++) assert_true(results[8 * i] < 1e29f);
    context_close(&context);
}

/* The solids of test_solids() about their centre: near the surface, the distance to it; negative inside. */
typedef double Solid(const double p[3]);

static const double tilted[3] = {0.48, 0.6, 0.64};

static void split(const double p[3], double *along, double *across) {
    double squares = 0;
    *along = p[0] * tilted[0] + p[1] * tilted[1] + p[2] * tilted[2];
    for (int c = 0; c < 3; c++) squares += (p[c] - *along * tilted[c]) * (p[c] - *along * tilted[c]);
    *across = sqrt(squares);
}

static double corner(double x, double y, double z) {
    double out = sqrt(pow(fmax(x, 0), 2) + pow(fmax(y, 0), 2) + pow(fmax(z, 0), 2));
    return out + fmin(fmax(x, fmax(y, z)), 0);
}

static double solid_box(const double p[3]) {
    return corner(fabs(p[0]) - 0.7, fabs(p[1]) - 0.4, fabs(p[2]) - 1);
}

static double solid_rounded_box(const double p[3]) {
    return corner(fabs(p[0]) - 0.45, fabs(p[1]) - 0.15, fabs(p[2]) - 0.75) - 0.25;
}

static double solid_cylinder(const double p[3]) {
    double along, across;
    split(p, &along, &across);
    return corner(across - 0.4, fabs(along) - 0.8, -1);
}

static double solid_capsule(const double p[3]) {
    double along, across;
    split(p, &along, &across);
    return hypot(across, fmax(fabs(along) - 0.6, 0)) - 0.4;
}

static double solid_cone(const double p[3]) {
    double along, across;
    split(p, &along, &across);
    double side = (across * 1.6 - (0.8 - along) * 0.6) / hypot(1.6, 0.6);
    return fmax(side, -0.8 - along);
}

static double torus(const double p[3], double minor) {
    double along, across;
    split(p, &along, &across);
    return hypot(across - 0.8, along) - minor;
}

static double solid_torus(const double p[3]) {
    return torus(p, 0.3);
}

static double solid_thin_torus(const double p[3]) {
    return torus(p, 0.01);
}

static double solid_ellipsoid(const double p[3]) {
    static const double radii[3] = {1, 0.5, 0.15};
    double value = 0, slope = 0;
    for (int c = 0; c < 3; c++) value += pow(p[c] / radii[c], 2), slope += pow(p[c] / pow(radii[c], 2), 2);
    return 0.5 * (value - 1) / fmax(sqrt(slope), 1);
}

/* Rays at three scales from near (often inside), from afar and from very far. */
static void make_scaled_rays(void) {
    static const double scales[] = {1e-3, 1, 1e4}, reaches[] = {1.2, 10, 1000};
    random_state = 11;
    for (int i = 0; i < RAYS; i++) {
        float *origin = inputs + 8 * i, *direction = origin + 4;
        double scale = scales[i % 3], reach = scale * reaches[i / 3 % 3], v[3], length = 0;
        for (int c = 0; c < 3; c++) {
            origin[c] = (float)(reach * (2 * random_unit() - 1));
            v[c] = 1.2 * scale * (2 * random_unit() - 1) - (double)origin[c];
            length += v[c] * v[c];
        }
        for (int c = 0; c < 3; c++) direction[c] = (float)(v[c] / sqrt(length));
        origin[3] = (float)scale;
        if (i % 16 == 0) direction[0] = 0, direction[1] = -1, direction[2] = 0;
    }
}

static const double solid_centre[3] = {0.125, -0.25, 0.5};

/* The solid's value at t along a ray, all in units of the ray's scale. */
static double value_along(Solid *solid, int ray, double t, double out[3]) {
    double scale = (double)inputs[8 * ray + 3];
    point_at(ray, t * scale, out);
    for (int c = 0; c < 3; c++) out[c] = out[c] / scale - solid_centre[c];
    return solid(out);
}

/* 2 where the difference quotients of the solid do not settle: at an edge. */
static double normal_error(Solid *solid, const double p[3], const float *normal) {
    double gradient[2][3], lengths[2] = {0}, turn = 0, error = 0;
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 3; c++) {
            double h = k ? 1e-4 : 1e-5, low[3] = {p[0], p[1], p[2]}, high[3] = {p[0], p[1], p[2]};
            low[c] -= h, high[c] += h;
            gradient[k][c] = solid(high) - solid(low);
            lengths[k] += gradient[k][c] * gradient[k][c];
        }
    }
    for (int c = 0; c < 3; c++) {
        double g = gradient[0][c] / sqrt(lengths[0]);
        turn += pow(gradient[1][c] / sqrt(lengths[1]) - g, 2);
        error += pow((double)normal[c] - g, 2);
    }
    return turn > 1e-6 ? 2 : sqrt(error);
}

/* One ray: the first point on the surface, or none. Returns whether it hit. */
static bool check_solid(const char *name, Solid *solid, double roughness, int i, int *edges) {
    double p[3], scale = (double)inputs[8 * i + 3], t = (double)results[8 * i] / scale;
    double start = value_along(solid, i, 0, p), side = start < 0 ? -1 : 1, closest = 0, size = 1;
    for (int c = 0; c < 3; c++) closest -= p[c] * (double)inputs[8 * i + 4 + c], size += fabs(p[c]);
    double tolerance = 3e-7 * size;
    if (fabs(start) < 1e-4) return false;
    for (int k = 0; k < 300; k++) {
        double at = closest - 2 + 4 * k / 300.0;
        if (at < 0 || at > t * (1 - 1e-5)) continue;
        if (side * value_along(solid, i, at, p) < -tolerance) {
            fail_msg("%s: ray %d passes the surface at %g of %g: %g", name, i, at, t, solid(p));
        }
    }
    if (t > 1e20) return false;
    if (fabs(value_along(solid, i, t, p)) > tolerance) {
        fail_msg("%s: ray %d ends %g off the surface at %g", name, i, solid(p), t);
    }
    assert_true(results[8 * i + 1] == 5);
    double error = normal_error(solid, p, results + 8 * i + 4);
    *edges += error == 2;
    if (error != 2 && error > 1e-5 + roughness * tolerance) {
        fail_msg("%s: ray %d, normal off by %g at %g", name, i, error, t);
    }
    return true;
}

#define CENTRE "s * vec3(0.125, -0.25, 0.5)"
#define ENDS(reach)                                                                                          \
    "s * (vec3(0.125, -0.25, 0.5) - " reach " * vec3(0.48, 0.6, 0.64)), "                                    \
    "s * (vec3(0.125, -0.25, 0.5) + " reach " * vec3(0.48, 0.6, 0.64))"

static void test_solids(void **state) {
    (void)state;
    static const struct {
        const char *file, *call;
        Solid *solid;
        double roughness; /* how much a normal turns by a metre, for solids of metres */
    } cases[] = {
        {"box", "hit_box(ray, " CENTRE ", s * vec3(0.7, 0.4, 1.0), 5, hit);", solid_box, 1},
        {"rounded_box", "hit_rounded_box(ray, " CENTRE ", s * vec3(0.7, 0.4, 1.0), s * 0.25, 5, hit);",
         solid_rounded_box, 20},
        {"cylinder", "hit_cylinder(ray, " ENDS("0.8") ", s * 0.4, 5, hit);", solid_cylinder, 10},
        {"capsule", "hit_capsule(ray, " ENDS("0.6") ", s * 0.4, 5, hit);", solid_capsule, 10},
        {"cone", "hit_cone(ray, " ENDS("0.8") ", s * 0.6, 5, hit);", solid_cone, 1000},
        {"torus", "hit_torus(ray, " CENTRE ", vec3(0.48, 0.6, 0.64), s * 0.8, s * 0.3, 5, hit);", solid_torus,
         20},
        {"torus", "hit_torus(ray, " CENTRE ", vec3(0.48, 0.6, 0.64), s * 0.8, s * 0.01, 5, hit);",
         solid_thin_torus, 1000},
        {"ellipsoid", "hit_ellipsoid(ray, " CENTRE ", s * vec3(1.0, 0.5, 0.15), 5, hit);", solid_ellipsoid,
         200},
    };
    Context context;
    support_open(&context);
    make_scaled_rays();
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char file[64];
        int hits = 0, edges = 0;
        snprintf(file, sizeof file, "shape/%s.glsl", cases[k].file);
        shoot(&context, file, cases[k].call);
        for (int i = 0; i < RAYS; i++) {
            hits += check_solid(cases[k].file, cases[k].solid, cases[k].roughness, i, &edges);
        }
        assert_true(hits > RAYS / 128 && edges <= hits / 50);
    }
    context_close(&context);
}

static void test_disk(void **state) {
    (void)state;
    Context context;
    int hits = 0;
    support_open(&context);
    make_scaled_rays();
    shoot(&context, "shape/disk.glsl", "hit_disk(ray, " CENTRE ", vec3(0.48, 0.6, 0.64), s * 0.9, 5, hit);");
    for (int i = 0; i < RAYS; i++) {
        double p[3], scale = (double)inputs[8 * i + 3], t = (double)results[8 * i] / scale, slope = 0;
        double height, across, reach;
        value_along(solid_box, i, 0, p);
        split(p, &height, &reach);
        for (int c = 0; c < 3; c++) slope += (double)inputs[8 * i + 4 + c] * tilted[c];
        double crossing = -height / slope, tolerance = 1e-6 * (1 + reach + fabs(height)) / fabs(slope);
        value_along(solid_box, i, crossing, p);
        split(p, &height, &across);
        if (fabs(slope) < 1e-3 || fabs(across - 0.9) < tolerance || fabs(crossing) < tolerance) continue;
        if (crossing < 0 || across > 0.9) {
            assert_true(t > 1e20);
            continue;
        }
        hits++;
        assert_true(fabs(t - crossing) < tolerance && results[8 * i + 1] == 5);
        for (int c = 0; c < 3; c++) assert_true(fabs((double)results[8 * i + 4 + c] - tilted[c]) < 1e-6);
    }
    assert_true(hits > RAYS / 8);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sphere),
        cmocka_unit_test(test_plane),
        cmocka_unit_test(test_plane_minus_sphere),
        cmocka_unit_test(test_rim),
        cmocka_unit_test(test_solids),
        cmocka_unit_test(test_disk),
    };
    return cmocka_run_group_tests_name("shape", tests, support_folder, support_clean);
}
