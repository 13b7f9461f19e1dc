/* Rough metal keeps its energy: what leaves after all reflections between its facets, against random walks.
 */
#include "facets.h"
#include "support.h"

#include "image/format.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

enum { ROUGHNESSES = 20, COSINES = 12 };

static const double cosines[COSINES] = {1, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.05, 0.02};

static double roughness_of(int row) {
    return 0.05 * (row + 1);
}

/* The albedos of three tints, for each roughness (rows) and cosine (columns): the mean weight of samples that
 * lie evenly. */
static void measure_albedos(const double tints[3], float results[4 * ROUGHNESSES * COSINES]) {
    static float inputs[4 * ROUGHNESSES * COSINES];
    char glsl[2048];
    Context context;
    support_open(&context);
    for (int i = 0; i < ROUGHNESSES * COSINES; i++) {
        inputs[4 * i] = (float)roughness_of(i / COSINES);
        inputs[4 * i + 1] = (float)cosines[i % COSINES];
    }
    snprintf(glsl, sizeof glsl,
             "#include \"scene.glsl\"\n#include \"material/rough_metal.glsl\"\n"
             "uniform sampler2D inputs;\n"
             "vec4 evaluate(vec2 texel) {\n"
             "    vec4 a = texelFetch(inputs, ivec2(texel), 0);\n"
             "    vec3 normal = normalize(vec3(0.3, 0.8, -0.5));\n"
             "    vec3 incoming = in_frame(normal, sqrt(1.0 - a.y * a.y), 0.0, -a.y);\n"
             "    Material metal = rough_metal(vec3(%.9f, %.9f, %.9f), a.x);\n"
             "    vec3 sum = vec3(0);\n"
             "    for (int i = 0; i < 512; i++) {\n"
             "        vec3 row = vec3(0);\n"
             "        for (int k = 0; k < 64; k++) {\n"
             "            vec2 u = vec2((float(i) + 0.5) / 512.0, (float(k) + 0.5) / 64.0);\n"
             "            row += rough_metal_sample(metal, normal, incoming, u, u).weight;\n"
             "        }\n"
             "        sum += row / 64.0;\n"
             "    }\n"
             "    return vec4(sum / 512.0, 0);\n}",
             tints[0], tints[1], tints[2]);
    support_evaluate(&context, glsl, inputs, COSINES, ROUGHNESSES, results);
    context_close(&context);
}

/* In a white furnace, metal with a tint of 1 cannot be seen. */
static void test_furnace(void **state) {
    (void)state;
    static const double tints[3] = {1, 1, 1};
    static float results[4 * ROUGHNESSES * COSINES];
    double worst = 0, smooth = 0;
    measure_albedos(tints, results);
    for (int i = 0; i < ROUGHNESSES * COSINES; i++) {
        double off = (double)results[4 * i] - 1;
        if (!(fabs(off) <= fabs(worst))) worst = off;
        if (!(fabs(off) < 0.003)) {
            fail_msg("roughness %g, cosine %g: reflects 1%+.5f", roughness_of(i / COSINES),
                     cosines[i % COSINES], off);
        }
        /* The fit is nearer toward the mirror, and exact at roughness 1. */
        bool near_mirror = roughness_of(i / COSINES) < 0.11 && cosines[i % COSINES] > 0.65;
        if (near_mirror || i / COSINES == ROUGHNESSES - 1) {
            smooth = fmax(smooth, fabs(off));
            assert_true(fabs(off) < 5e-4);
        }
    }
    print_message("a tint of 1 reflects 1%+.5f at worst, %.5f from 1 near the mirror and at roughness 1\n",
                  worst, smooth);
}

/* Nor can balls of it be seen that reflect each other, whichever way directions are drawn. */
static void test_white_balls(void **state) {
    (void)state;
    static const char *const lights[] = {"cosine", "mis"};
    const char *scene =
        support_write("white.glsl", "//@ camera eye 0 0 -8  target 0 0 0  fov 40\n//@ sky uniform:1\n"
                                    "#include \"material/rough_metal.glsl\"\n#include \"shape/sphere.glsl\"\n"
                                    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                                    "    hit_sphere(ray, vec3(-1.4, -1.4, 0.0), 1.0, 0, hit);\n"
                                    "    hit_sphere(ray, vec3(1.4, -1.4, 0.0), 1.0, 1, hit);\n"
                                    "    hit_sphere(ray, vec3(-1.4, 1.4, 0.0), 1.0, 2, hit);\n"
                                    "    hit_sphere(ray, vec3(1.4, 1.4, 0.0), 1.0, 3, hit);\n}\n"
                                    "Material scene_material(Hit hit) {\n"
                                    "    return rough_metal(vec3(1.0), 0.25 * float(hit.object + 1));\n}\n");
    for (int k = 0; k < 2; k++) {
        Image image;
        Error error;
        double mean[2][2] = {{0}}, count[2][2] = {{0}};
        support_expect(0, "", "render '%s' --light %s --size 96x96 --spp 1024 --quiet -o '%s'", scene,
                       lights[k], support_path("white.pfm"));
        assert_true(image_read(&image, support_path("white.pfm"), &error));
        for (int i = 0; i < 96 * 96; i++) {
            double value = (double)image.rgba[4 * i];
            int x = i % 96 / 48, y = i / 96 / 48;
            if (fabs(value - 1) < 1e-7) continue; /* past the balls */
            mean[y][x] += value;
            count[y][x]++;
        }
        image_free(&image);
        for (int i = 0; i < 4; i++) {
            double ball = mean[i / 2][i % 2] / count[i / 2][i % 2];
            print_message("%s, a white ball in the picture: 1%+.4f\n", lights[k], ball - 1);
            assert_true(count[i / 2][i % 2] > 500 && fabs(ball - 1) < 0.007); /* the fit and the noise */
        }
    }
}

/* At alpha 1 the light that leaves after one facet has a closed form. */
static void test_walk(void **state) {
    (void)state;
    static const double tints[FACETS_TINTS] = {1, 0, 0.5, 0.5, 0.5, 0.5, 0.5};
    const uint64_t walks = 400000;
    for (int k = 0; k < COSINES; k++) {
        double c = cosines[k], once = 1 - c * log((1 + c) / c);
        FacetsAlbedo albedo = facets_albedo(1, tints, c, walks);
        assert_true(fabs(albedo.once[0] - once) < 4 * sqrt(once * (1 - once) / (double)walks));
        assert_true(fabs(albedo.all[0] - 1) < 1e-9);
        assert_true(albedo.all[1] < albedo.all[2] && albedo.all[2] < albedo.all[0]);
    }
}

/* How far a model is from the walks. */
typedef struct Distance {
    double squares, worst;
    int count;
} Distance;

static void distance_add(Distance *distance, double model, double truth) {
    double off = fabs(model - truth);
    distance->squares += off * off;
    distance->worst = fmax(distance->worst, off);
    distance->count++;
}

/* Coloured metal reflects what the walks say, to the error that rough_metal.glsl claims. Simpler models are
 * farther from them: one reflection only, and Turquin's factor with the tint itself. */
static void test_against_walk(void **state) {
    (void)state;
    static const double tints[FACETS_TINTS] = {0.02, 0.2, 0.4, 0.55, 0.7, 0.85, 1};
    static float results[2][4 * ROUGHNESSES * COSINES];
    Distance ours = {0}, once = {0}, turquin = {0};
    for (int set = 0; set < 2; set++) measure_albedos(tints + 3 * set, results[set]);
    for (int i = 0; i < ROUGHNESSES * COSINES; i++) {
        double roughness = roughness_of(i / COSINES);
        /* Every other roughness from 0.3, and six of the cosines. */
        if (i / COSINES % 2 == 0 || i / COSINES < 5 || i % COSINES % 2) continue;
        FacetsAlbedo albedo = facets_albedo(roughness * roughness, tints, cosines[i % COSINES], 300000);
        double left = albedo.once[FACETS_TINTS - 1];
        for (int k = 0; k < FACETS_TINTS - 1; k++) {
            distance_add(&ours, (double)results[k / 3][4 * i + k % 3], albedo.all[k]);
            distance_add(&once, albedo.once[k], albedo.all[k]);
            distance_add(&turquin, albedo.once[k] * (1 + tints[k] * (1 - left) / left), albedo.all[k]);
        }
    }
    double rms = sqrt(ours.squares / ours.count), rms_turquin = sqrt(turquin.squares / turquin.count);
    print_message("from the walks: %.4f at worst, %.4f RMS; Turquin's factor %.4f, %.4f; one facet %.4f\n",
                  ours.worst, rms, turquin.worst, rms_turquin, once.worst);
    assert_true(ours.worst < 0.014 && rms < 0.005); /* with the walks' noise, 0.001 */
    assert_true(turquin.worst > 0.04 && rms_turquin > 2 * rms && once.worst > 0.3);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_furnace), cmocka_unit_test(test_white_balls),
                                       cmocka_unit_test(test_walk), cmocka_unit_test(test_against_walk)};
    return cmocka_run_group_tests_name("metal", tests, support_folder, support_clean);
}
