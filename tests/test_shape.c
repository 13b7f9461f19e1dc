/* Exact shapes on the GPU: what they hit lies on them, nothing solid lies before it, and normals are theirs.
 */
#include "support.h"

#include <math.h>
#include <stdio.h>

enum { RAYS = 64 * 64 };

static float inputs[8 * RAYS], results[8 * RAYS];

static double random_unit(unsigned *state) {
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

/* Rays in pairs of texels, origin and direction; half of them aimed near the sphere, some skimming it. */
static void make_rays(double scale, double lowest, const double centre[3], double radius) {
    unsigned seed = 7;
    for (int i = 0; i < RAYS; i++) {
        float *origin = inputs + 8 * i, *direction = origin + 4;
        double length = 0, target[3], v[3];
        for (int c = 0; c < 3; c++) {
            origin[c] = (float)(scale * (2 * random_unit(&seed) - 1));
            target[c] = centre[c] + (i % 2 ? 1.2 : 8) * radius * (2 * random_unit(&seed) - 1);
        }
        if ((double)origin[1] < lowest) origin[1] = (float)(lowest - (double)origin[1]);
        for (int c = 0; c < 3; c++) v[c] = target[c] - (double)origin[c], length += v[c] * v[c];
        for (int c = 0; c < 3; c++) direction[c] = (float)(v[c] / sqrt(length));
    }
}

/* Results in pairs of texels: (t, object, 0, 0), normal. `call` adds hits to `hit`. */
static void shoot(const Context *context, const char *file, const char *call) {
    char glsl[1024];
    snprintf(
        glsl, sizeof glsl,
        "#include \"%s\"\nuniform sampler2D inputs;\n"
        "vec4 evaluate(vec2 t) {\n"
        "    ivec2 at = ivec2(int(t.x) / 2 * 2, int(t.y));\n"
        "    Ray ray = Ray(texelFetch(inputs, at, 0).xyz, texelFetch(inputs, at + ivec2(1, 0), 0).xyz);\n"
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sphere),
        cmocka_unit_test(test_plane),
        cmocka_unit_test(test_plane_minus_sphere),
        cmocka_unit_test(test_rim),
    };
    return cmocka_run_group_tests_name("shape", tests, support_folder, support_clean);
}
