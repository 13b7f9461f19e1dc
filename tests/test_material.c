/* Materials: what is drawn is what the density says, nothing is won, and glass obeys Snell and Fresnel. */
#include "support.h"

#include "source/glsl_source.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 512, TEXELS = SIDE * SIDE, ACROSS = 32, AROUND = 16, BINS = ACROSS * AROUND };

static float results[4 * TEXELS];
static const double pi = 3.14159265358979;
static const double roughnesses[] = {0.05, 0.2, 0.5, 1};
static const double incidences[] = {0, 45, 80};

/* A material `m`, made by `constructor`, met at `incidence` degrees on a tilted plane. The sphere of
 * directions is mapped to the unit square about the mirror's direction, so that the lobe fills it: `lobe` is
 * the lobe's width, squared. Then `evaluate`. */
static void evaluate(const Context *context, const char *name, const char *constructor, double incidence,
                     double lobe, const char *rest) {
    char glsl[4096];
    snprintf(glsl, sizeof glsl,
             "#include \"scene.glsl\"\n#include \"material/%s.glsl\"\n#include \"math/hash.glsl\"\n"
             "#include \"light/lambert.glsl\"\n"
             "#define NAME(what) %s_##what\n"
             "const float LOBE = %.9f;\n"
             "vec3 normal = normalize(vec3(1, -2, 0.5)), tx = normalize(cross(normal, vec3(0, 0, 1)));\n"
             "vec3 ty = cross(normal, tx);\n"
             "vec3 in_direction = %.9f * tx - %.9f * normal;\n"
             "vec3 mirrored = reflect(in_direction, normal);\n"
             "vec3 mx = normalize(cross(mirrored, ty)), my = cross(mirrored, mx);\n"
             "vec4 random(vec2 t, uint k) {\n"
             "    uvec3 a = hash_3(uvec3(uvec2(t), k)), b = hash_3(uvec3(uvec2(t), k + 1u));\n"
             "    return vec4(unit_float(a.x), unit_float(a.y), unit_float(b.x), unit_float(b.y));\n}\n"
             "vec2 to_square(vec3 d) {\n"
             "    vec3 off = d - mirrored;\n    float w = 0.25 * dot(off, off);\n"
             "    return vec2(w * (1.0 + LOBE) / (w + LOBE), 0.5 + atan(dot(d, my), dot(d, mx)) / (2.0 * "
             "PI));\n}\n"
             /* the direction, and the solid angle over the square's area */
             "vec4 from_square(vec2 s) {\n"
             "    float w = LOBE * s.x / (1.0 + LOBE - s.x), r = 2.0 * sqrt(w * (1.0 - w)), a = 2.0 * PI * "
             "(s.y - 0.5);\n"
             "    float stretch = LOBE * (1.0 + LOBE) / ((1.0 + LOBE - s.x) * (1.0 + LOBE - s.x));\n"
             "    return vec4(r * cos(a) * mx + r * sin(a) * my + (1.0 - 2.0 * w) * mirrored, 4.0 * PI * "
             "stretch);\n}\n"
             "Material m;\n%s\nvec4 evaluate(vec2 t) { m = %s; return answer(t); }",
             name, name, lobe, sin(incidence * pi / 180), cos(incidence * pi / 180), rest, constructor);
    support_evaluate(context, glsl, NULL, SIDE, SIDE, results);
}

static double mean(int component) {
    double sum = 0;
    for (int i = 0; i < TEXELS; i++) sum += (double)results[4 * i + component];
    return sum / TEXELS;
}

/* Standard deviations from the expectation (Wilson and Hilferty); bins of few are taken together. */
static double chi_square_deviations(const double *counts, const double *expected) {
    double chi2 = 0, degrees = -1, few = 0, few_expected = 0;
    for (int i = 0; i < BINS; i++) {
        if (expected[i] < 10) {
            few += counts[i];
            few_expected += expected[i];
        } else {
            chi2 += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
            degrees++;
        }
    }
    if (few_expected > 10 || few > 30) {
        chi2 += (few - few_expected) * (few - few_expected) / fmax(few_expected, 1);
        degrees++;
    }
    return (cbrt(chi2 / degrees) - (1 - 2 / (9 * degrees))) / sqrt(2 / (9 * degrees));
}

typedef struct Measured {
    double deviations; /* of the chi-square */
    double pdf;        /* integral over all directions */
    double pdf_above;  /* over those above the surface */
    double value;      /* integral: the albedo */
    double weight;     /* mean: the albedo too */
    double most;       /* the largest weight */
} Measured;

static Measured measure(const Context *context, const char *name, const char *constructor, double incidence,
                        double lobe) {
    static double counts[BINS], expected[BINS];
    Measured measured = {0};
    memset(counts, 0, sizeof counts);
    memset(expected, 0, sizeof expected);
    evaluate(
        context, name, constructor, incidence, lobe,
        "vec4 answer(vec2 t) {\n    vec4 sum = vec4(0);\n"
        "    for (int i = 0; i < 16; i++) {\n"
        "        vec4 d = from_square((t + vec2(float(i % 4) + 0.5, float(i / 4) + 0.5) / 4.0) / 512.0);\n"
        "        float pdf = d.w * NAME(pdf)(m, normal, in_direction, d.xyz);\n"
        "        float value = d.w * NAME(value)(m, normal, in_direction, d.xyz).x;\n"
        "        sum += vec4(pdf, dot(d.xyz, normal) > 0.0 ? pdf : 0.0, value, 0) / 16.0;\n"
        "    }\n    return sum;\n}");
    for (int i = 0; i < TEXELS; i++) {
        assert_true(isfinite(results[4 * i]) && results[4 * i] >= 0 && results[4 * i + 2] >= 0);
        expected[i % SIDE / (SIDE / ACROSS) * AROUND + i / SIDE / (SIDE / AROUND)] += (double)results[4 * i];
    }
    measured.pdf = mean(0);
    measured.pdf_above = mean(1);
    measured.value = mean(2);
    evaluate(context, name, constructor, incidence, lobe,
             "vec4 answer(vec2 t) {\n    vec4 r = random(t, 7u);\n"
             "    Bounce b = NAME(sample)(m, normal, in_direction, r.xy, r.zw);\n"
             "    float pdf = NAME(pdf)(m, normal, in_direction, b.direction);\n"
             "    vec3 value = NAME(value)(m, normal, in_direction, b.direction);\n"
             "    vec3 off = abs(b.weight * b.pdf - value) / (b.pdf + value);\n"
             "    float worst = max(max(off.x, max(off.y, off.z)), abs(pdf / b.pdf - 1.0));\n"
             "    worst = max(worst, 10.0 * abs(length(b.direction) - 1.0));\n"
             "    return vec4(to_square(b.direction), b.weight.x, worst);\n}");
    double worst = 0;
    for (int i = 0; i < TEXELS; i++) {
        const float *v = results + 4 * i;
        assert_true(isfinite(v[2]) && v[2] >= 0 && isfinite(v[3]));
        measured.most = fmax(measured.most, (double)v[2]);
        worst = fmax(worst, (double)v[3]);
        counts[(int)(fmin((double)v[0], 0.999999) * ACROSS) * AROUND +
               (int)(fmin((double)v[1], 0.999999) * AROUND)]++;
    }
    if (worst > 2e-3) {
        fail_msg("%s at %g: weight, density and value disagree by %g", constructor, incidence, worst);
    }
    measured.weight = mean(2);
    measured.deviations = chi_square_deviations(counts, expected);
    print_message("%s at %g: chi-square %.1f off; pdf %.5f, above %.5f; albedo %.5f, by samples %.5f\n",
                  constructor, incidence, measured.deviations, measured.pdf, measured.pdf_above,
                  measured.value, measured.weight);
    if (fabs(measured.deviations) > 4 || fabs(measured.pdf - 1) > 2e-3 || measured.pdf_above > 1.002 ||
        fabs(measured.value - measured.weight) > 4e-3) {
        fail_msg("%s at %g", constructor, incidence);
    }
    return measured;
}

/* Lambert's: all of the albedo, whichever way the light came. */
static void test_matte(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    for (int k = 0; k < 3; k++) {
        Measured measured = measure(&context, "matte", "matte(vec3(0.8, 0.5, 0.25))", incidences[k], 1);
        assert_true(measured.most < 0.80001 && fabs(measured.weight - 0.8) < 1e-6 &&
                    fabs(measured.value - 0.8) < 1e-3);
        assert_true(fabs(measured.pdf_above - 1) < 1e-3);
    }
    context_close(&context);
}

/* All light goes on. A sample is worth more than the light that it stands for, since it also stands for light
 * that meets several facets: of the light that comes at cosine c, the share 1 - c log((1 + c) / c) meets one
 * facet only at roughness 1, and a larger share at others. */
static void test_rough_metal(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    for (int k = 0; k < 12; k++) {
        double roughness = roughnesses[k / 3], incidence = incidences[k % 3], c = cos(incidence * pi / 180);
        char constructor[128];
        snprintf(constructor, sizeof constructor, "rough_metal(vec3(1, 0.5, 0.25), %.4f)", roughness);
        Measured measured = measure(&context, "rough_metal", constructor, incidence, pow(roughness, 4));
        assert_true(fabs(measured.value - 1) < 4e-3);
        assert_true(measured.most > 0.999 && measured.most < 1.0001 / (1 - c * log((1 + c) / c)));
        if (roughness < 0.1 && incidence < 50) assert_true(fabs(measured.weight - 1) < 1e-3);
    }
    context_close(&context);
}

/* Roughness 0 is finite, and a mirror but for a little. */
static void test_smooth_metal(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    for (int k = 0; k < 4; k++) {
        double incidence = k < 3 ? incidences[k] : 90;
        evaluate(&context, "rough_metal", "rough_metal(vec3(1), 0.0)", incidence, 1e-6,
                 "vec4 answer(vec2 t) {\n    vec4 r = random(t, 9u);\n"
                 "    Bounce b = rough_metal_sample(m, normal, in_direction, r.xy, r.zw);\n"
                 "    vec3 v = rough_metal_value(m, normal, in_direction, b.direction);\n"
                 "    return vec4(b.weight.x, b.pdf, v.x, length(b.direction - mirrored));\n}");
        for (int i = 0; i < 4 * TEXELS; i++) assert_true(isfinite(results[i]) && results[i] >= 0);
        if (k < 3) assert_true(mean(0) > 0.999 && mean(3) < 0.01);
    }
    context_close(&context);
}

/* value / cosine is the same either way, once it is divided by `reflectance`. This is an expression of the
 * direction from which the light is looked at, `from`, and of the other one, `to`. */
static void expect_reciprocal(const Context *context, const char *name, const char *constructor,
                              const char *reflectance) {
    char rest[1536];
    snprintf(rest, sizeof rest,
             "vec3 up(float z, float a) {\n"
             "    float r = sqrt(1.0 - z * z);\n"
             "    return r * cos(2.0 * PI * a) * tx + r * sin(2.0 * PI * a) * ty + z * normal;\n}\n"
             "vec3 reflectance(vec3 from, vec3 to) { return vec3(%s); }\n"
             "vec4 answer(vec2 t) {\n    vec4 r = random(t, 3u);\n"
             "    vec3 a = up(mix(0.02, 1.0, r.x), r.y), b = up(mix(0.02, 1.0, r.z), r.w);\n"
             "    vec3 there = %s_value(m, normal, -a, b) / dot(b, normal) / reflectance(a, b);\n"
             "    vec3 back = %s_value(m, normal, -b, a) / dot(a, normal) / reflectance(b, a);\n"
             "    return vec4(abs(there - back) / max(there, back), 0);\n}",
             reflectance, name, name);
    evaluate(context, name, constructor, 0, 1, rest);
    float worst = 0;
    for (int i = 0; i < 4 * TEXELS; i++) worst = fmaxf(worst, results[i]);
    if (!(worst < 1e-3f)) fail_msg("%s: %g", constructor, (double)worst);
}

/* What light that meets several facets adds to metal depends on the cosine toward the camera. The rest is
 * the same either way. */
static void test_reciprocity(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    expect_reciprocal(&context, "matte", "matte(vec3(0.8, 0.5, 0.25))", "1.0");
    for (int k = 0; k < 4; k++) {
        char constructor[128];
        snprintf(constructor, sizeof constructor, "rough_metal(gold(), %.4f)", roughnesses[k]);
        expect_reciprocal(&context, "rough_metal", constructor,
                          "rough_metal_reflectance(m, dot(from, normal), sqrt(0.5 + 0.5 * dot(from, to)))");
    }
    context_close(&context);
}

/* What goes through the surface of glass comes back the same way, and as much of it. */
static void test_glass_back(void **state) {
    (void)state;
    Context context;
    double off = 0, apart = 0;
    support_open(&context);
    evaluate(&context, "glass", "glass(1.5)", 0, 1,
             "vec4 answer(vec2 t) {\n    float a = 0.49 * PI * (t.y + 0.5) / 512.0;\n"
             "    vec3 d = sin(a) * tx - cos(a) * normal;\n"
             "    Bounce in_glass = glass_sample(m, normal, d, vec2(0.5), vec2(1.0));\n"
             "    Bounce back = glass_sample(glass(1.0 / m.ior), -normal, -in_glass.direction, vec2(0.5), "
             "vec2(1.0));\n"
             "    float here = -dot(d, normal), beyond = -dot(in_glass.direction, normal);\n"
             "    float there = glass_fresnel(m.ior, here, beyond);\n"
             "    return vec4(length(back.direction + d), abs(there - glass_fresnel(1.0 / m.ior, beyond, "
             "here)), here, beyond);\n}");
    for (int i = 0; i < TEXELS; i++) {
        const float *v = results + 4 * i;
        assert_true(v[2] > 0 && v[3] > 0.7f); /* Snell's critical angle: cosine 0.745 */
        off = fmax(off, (double)v[0]);
        apart = fmax(apart, (double)v[1]);
    }
    print_message("glass, there and back: direction off by %.1e, reflectances apart by %.1e\n", off, apart);
    assert_true(off < 1e-5 && apart < 1e-5);
    context_close(&context);
}

/* The author's ball: the density of its directions, and nothing lost but the absorbance. */
static void test_author(void **state) {
    (void)state;
    static const double shares[] = {0, 0.5, 1};
    Context context;
    support_open(&context);
    for (int k = 0; k < 18; k++) {
        static const double rough[] = {0.05, 0.5, 1};
        double share = shares[k / 6], roughness = rough[k / 2 % 3], incidence = incidences[1 + k % 2];
        char constructor[128];
        snprintf(constructor, sizeof constructor, "author(vec3(1), %.2f, %.2f, 0.1)", share, roughness);
        Measured measured = measure(&context, "author", constructor, incidence,
                                    share > 0.6 ? roughness * roughness / 4 : 0.25 * roughness);
        assert_true(measured.most < 0.90001 && fabs(measured.weight - 0.9) < 1e-5 &&
                    fabs(measured.pdf_above - 1) < 2e-3);
    }
    context_close(&context);
}

/* Fresnel by angles, in the form that has no index of refraction. */
static double fresnel(double angle, double beyond) {
    if (angle < 1e-6) angle = 1e-6;
    double across = sin(angle - beyond) / sin(angle + beyond),
           parallel = tan(angle - beyond) / tan(angle + beyond);
    return 0.5 * (across * across + parallel * parallel);
}

/* Rows are angles of incidence, columns choose between reflection and refraction. */
static void test_glass(void **state) {
    (void)state;
    static const double iors[] = {1.5, 1 / 1.5, 1.33, 1 / 2.4, 2.4, 1.0001};
    Context context;
    support_open(&context);
    for (int k = 0; k < 6; k++) {
        char constructor[64];
        int total = 0;
        snprintf(constructor, sizeof constructor, "glass(%.9f)", iors[k]);
        evaluate(
            &context, "glass", constructor, 0, 1,
            "vec4 answer(vec2 t) {\n    float a = 0.5 * PI * (t.y + 0.5) / 512.0;\n"
            "    vec3 d = sin(a) * tx - cos(a) * normal;\n"
            "    Bounce b = glass_sample(m, normal, d, vec2(0.5), vec2((t.x + 0.5) / 512.0, 0.5));\n"
            "    bool fine = b.pdf == 0.0 && b.weight == vec3(1) && abs(dot(b.direction, ty)) < 1e-6 &&\n"
            "                abs(length(b.direction) - 1.0) < 1e-6;\n"
            "    return vec4(dot(b.direction, tx), dot(b.direction, normal), fine, 0);\n}");
        for (int y = 0; y < SIDE; y++) {
            double angle = 0.5 * pi * (y + 0.5) / SIDE, sine = sin(angle) / iors[k], share = 0;
            bool totally = sine > 1;
            for (int x = 0; x < SIDE; x++) {
                const float *v = results + 4 * (SIDE * y + x);
                bool reflected = v[1] > 0;
                share += reflected ? 1.0 / SIDE : 0;
                assert_true(v[2] == 1);
                if (fabs((double)v[0] - (reflected ? sin(angle) : sine)) > 1e-6) {
                    fail_msg("%s: not Snell's law at %g", constructor, angle);
                }
            }
            double expected = totally ? 1 : fresnel(angle, asin(sine));
            total += totally;
            if (fabs(share - expected) > 1.01 / SIDE || (totally && share < 1)) {
                fail_msg("%s: reflects %.4f at %g, expected %.4f", constructor, share, angle, expected);
            }
        }
        assert_true((total > 0) == (iors[k] < 1));
    }
    context_close(&context);
}

/* A ray through a plate leaves it as it came, aside by Snell's law; what enters a ball of glass leaves it,
 * with a weight of 1 at every hit: it is invisible in a white furnace. */
static void test_passage(void **state) {
    (void)state;
    static const char scene[] =
        "#include \"scene.glsl\"\n#include \"light/surface.glsl\"\n#include \"material/glass.glsl\"\n"
        "#include \"math/hash.glsl\"\n#include \"math/sphere_sample.glsl\"\n"
        "#include \"shape/box.glsl\"\n#include \"shape/sphere.glsl\"\n#include <materials>\n"
        "vec3 sky_radiance(vec3 d) { return vec3(1); }\n"
        "Material scene_material(Hit hit) { return glass(1.5); }\n";
    char glsl[4096];
    Context context;
    support_open(&context);
    snprintf(glsl, sizeof glsl,
             "%svoid scene_intersect(Ray ray, inout Hit hit) {\n"
             "    hit_box(ray, vec3(0), vec3(100, 0.5, 100), 1, hit);\n}\n"
             "vec4 evaluate(vec2 t) {\n    float a = 0.49 * PI * t.y / 512.0;\n"
             "    vec3 d = vec3(sin(a), -cos(a), 0), first;\n    Ray ray = Ray(vec3(-1, 2, 0), d);\n"
             "    bool fine = true;\n"
             "    for (int i = 0; i < 2; i++) {\n"
             "        Hit hit = surface_hit(ray);\n"
             "        if (i == 0) first = hit.position;\n"
             "        fine = fine && hit.object == 1 && hit.inside == (i == 1) && dot(hit.normal, "
             "ray.direction) < 0.0;\n"
             "        ray = ray_from(hit, material_sample(surface_material(hit), hit.normal, ray.direction, "
             "vec2(0.5), vec2(0.9999)).direction);\n"
             "    }\n"
             "    float aside = ray.origin.x - first.x, expected = tan(asin(sin(a) / 1.5));\n"
             "    fine = fine && surface_hit(ray).t >= INFINITY;\n"
             "    return vec4(fine, length(ray.direction - d), abs(aside - expected), 0);\n}",
             scene);
    support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
    for (int i = 0; i < TEXELS; i++) {
        const float *v = results + 4 * i;
        if (v[0] != 1 || v[1] > 1e-5f || v[2] > 5e-4f) {
            fail_msg("plate, row %d: %g %g %g", i / SIDE, (double)v[0], (double)v[1], (double)v[2]);
        }
    }
    snprintf(
        glsl, sizeof glsl,
        "%svoid scene_intersect(Ray ray, inout Hit hit) { hit_sphere(ray, vec3(3, 1, 2), 1.0, 1, hit); }\n"
        "vec4 evaluate(vec2 t) {\n    uvec3 h = hash_3(uvec3(uvec2(t), 5u));\n"
        "    vec3 d = sphere_sample(vec2(unit_float(h.x), unit_float(h.y)));\n"
        "    uvec3 g = hash_3(h);\n"
        "    vec3 aim = vec3(3, 1, 2) + sphere_sample(vec2(unit_float(g.x), unit_float(g.y)));\n"
        "    Ray ray = Ray(aim - 5.0 * d, d);\n    int hits = 0;\n    bool inside = false, fine = true;\n"
        "    Hit hit = surface_hit(ray);\n"
        "    while (hit.t < INFINITY && hits < 40) {\n"
        "        fine = fine && hit.inside == inside;\n"
        "        g = hash_3(g);\n"
        "        Bounce b = material_sample(surface_material(hit), hit.normal, ray.direction, vec2(0.5), "
        "vec2(unit_float(g.x), 0.5));\n"
        "        if (dot(b.direction, hit.normal) < 0.0) inside = !inside;\n"
        "        ray = ray_from(hit, b.direction);\n        hit = surface_hit(ray);\n        hits += 1;\n"
        "    }\n    return vec4(fine, hits, inside, 0);\n}",
        scene);
    support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
    /* A ray that just grazes on its way in is reflected in there, again and again. */
    int wrong = 0, caught = 0;
    for (int i = 0; i < TEXELS; i++) {
        bool out = results[4 * i + 1] < 40;
        wrong += results[4 * i] != 1 || (out && results[4 * i + 2] != 0);
        caught += !out;
    }
    print_message("ball: of %d paths %d lose count of the sides, and %d are inside after 40 hits\n", TEXELS,
                  wrong, caught);
    assert_true(wrong == 0 && caught < 20);
    context_close(&context);
}

/* Noise keeps to [0,1], is 1/2 in the mean and has no seams. */
static void test_colors(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    support_evaluate(
        &context,
        "#include \"color/gradient.glsl\"\n#include \"color/grid.glsl\"\n#include \"color/noise.glsl\"\n"
        "vec4 evaluate(vec2 t) {\n    vec3 p = vec3(0.25 * (t.x - 256.0), 0.3, 0.25 * (t.y - 256.0));\n"
        "    float step = abs(noise(p) - noise(p - vec3(1e-3, 1e-3, 1e-3)));\n"
        "    vec3 g = gradient(vec3(p.x, 5, 0), vec3(0), vec3(2, 0, 0), vec3(1), vec3(3));\n"
        "    vec3 line = grid(p + 0.1, 0.21, vec3(1), vec3(0));\n"
        "    bool fine = abs(g.x - (1.0 + clamp(p.x, 0.0, 2.0))) < 1e-6 &&\n"
        "                line.x == float(fract(p.x) == 0.0 || fract(p.z) == 0.0);\n"
        "    return vec4(noise(p), noise_octaves(p, 4), step, fine);\n}",
        NULL, SIDE, SIDE, results);
    for (int i = 0; i < TEXELS; i++) {
        const float *v = results + 4 * i;
        assert_true(v[0] >= 0 && v[0] <= 1 && v[1] >= 0 && v[1] <= 1 && v[2] < 0.01f && v[3] == 1);
    }
    assert_true(fabs(mean(0) - 0.5) < 0.01 && fabs(mean(1) - 0.5) < 0.01);
    context_close(&context);
}

/* Three shares of one whole: all of it on a face, a third each in a corner, and the more of one the sharper.
 */
static void test_triplanar(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    support_evaluate(
        &context,
        "#include \"color/triplanar.glsl\"\n#include \"math/hash.glsl\"\n"
        "vec4 evaluate(vec2 t) {\n    uvec3 random = hash_3(uvec3(uvec2(t), 0u));\n"
        "    vec3 n = normalize(vec3(unit_float(random.x), unit_float(random.y), unit_float(random.z)) - "
        "0.5);\n"
        "    vec3 soft = triplanar(n, 1.0), sharp = triplanar(-3.0 * n, 8.0);\n"
        "    return vec4(soft.x + soft.y + soft.z - 1.0,\n"
        "                max(max(sharp.x, sharp.y), sharp.z) - max(max(soft.x, soft.y), soft.z),\n"
        "                length(triplanar(vec3(0.0, -2.0, 0.0), 4.0) - vec3(0.0, 1.0, 0.0)),\n"
        "                length(soft - abs(n) / (abs(n.x) + abs(n.y) + abs(n.z))));\n}",
        NULL, SIDE, SIDE, results);
    for (int i = 0; i < TEXELS; i++) {
        const float *v = results + 4 * i;
        assert_true(fabs((double)v[0]) < 1e-6 && v[1] >= -1e-6f && v[2] == 0 && v[3] < 1e-6f);
    }
    context_close(&context);
}

static void flatten_crater(GlslSource *source, const char *library) {
    const GlslSlot slots[] = {{"scene", "scenes/crater.glsl", NULL}, {NULL, NULL, NULL}};
    Error error;
    const char *entry = support_write(
        "entry.glsl",
        "#include \"scene.glsl\"\n#include <scene>\n#include \"light/surface.glsl\"\n#include <materials>\n");
    if (!support_flatten(source, library, entry, slots, &error)) fail_msg("%s", error.text);
}

/* What a scene does not include is not there: the text is the same, to the byte, as if there were no such
 * files. */
static void test_not_included(void **state) {
    (void)state;
    GlslSource with, without;
    char command[1024];
    const char *library = support_path("library");
    snprintf(command, sizeof command,
             "cp -r glsl '%s' && cd '%s/material' && rm rough_metal.glsl glass.glsl author.glsl", library,
             library);
    assert_int_equal(system(command), 0);
    flatten_crater(&with, "glsl");
    flatten_crater(&without, library);
    assert_int_equal(with.text.size, without.text.size);
    assert_memory_equal(with.text.data, without.text.data, with.text.size);
    assert_null(strstr(text_string(&with.text), "glass"));
    glsl_source_destroy(&with);
    glsl_source_destroy(&without);
    snprintf(command, sizeof command, "rm -r '%s'", library);
    assert_int_equal(system(command), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_matte),        cmocka_unit_test(test_glass_back),
        cmocka_unit_test(test_rough_metal),  cmocka_unit_test(test_smooth_metal),
        cmocka_unit_test(test_reciprocity),  cmocka_unit_test(test_author),
        cmocka_unit_test(test_glass),        cmocka_unit_test(test_passage),
        cmocka_unit_test(test_colors),       cmocka_unit_test(test_triplanar),
        cmocka_unit_test(test_not_included),
    };
    return cmocka_run_group_tests_name("material", tests, support_folder, support_clean);
}
