/* Metropolis light transport: the law of a step and of a chain's start, the same pictures as those of
 * independent paths, the same bits however the work is done, and what is refused. */
#include "studio.h"
#include "support.h"
#include "ztest.h"

#include "render/chain_starts.h"
#include "render/renderer.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIDE = 256, TEXELS = SIDE * SIDE };

static float results[4 * TEXELS];

static void evaluate(const char *glsl) {
    Context context;
    support_open(&context);
    support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
    context_close(&context);
}

/* A move up and the move down by the same u lead back, to the bit. Both stay in [0,1), across its ends too.
 * The logarithm of the distance is uniform. */
static void test_moves(void **state) {
    (void)state;
    evaluate(
        "#include \"sequence/chain_step.glsl\"\n"
        "vec4 evaluate(vec2 texel) {\n"
        "    uvec3 h = hash_3(uvec3(uint(texel.x), uint(texel.y), 1u));\n"
        "    float x = texel.x < 1.0 ? 0.0 : texel.x < 2.0 ? 1.0 - 1.0 / 16777216.0 : unit_float(h.x);\n"
        "    float u = texel.y < 1.0 ? 0.0 : texel.y < 2.0 ? 1.0 - 1.0 / 16777216.0 : unit_float(h.y);\n"
        "    float up = chain_move(x, u, true);\n"
        "    return vec4(up, chain_move(up, u, false) - x, chain_move(chain_move(x, u, false), u, true) - "
        "x, up - x);\n"
        "}\n");
    int wrapped = 0, parts[4] = {0};
    for (int i = 0; i < TEXELS; i++) {
        const float *r = results + 4 * i;
        double way = (double)r[3] < 0 ? (double)r[3] + 1 : (double)r[3];
        assert_true(r[0] >= 0 && r[0] < 1 && r[1] == 0 && r[2] == 0);
        assert_true(way >= 1.0 / 1024 && way <= 1.0 / 64);
        wrapped += r[3] < 0;
        if (i >= 2 * SIDE) parts[(int)fmin(log2(way) + 10, 3)]++;
    }
    assert_true(wrapped >= SIDE);
    for (int k = 0; k < 4; k++) {
        double expected = (TEXELS - 2 * SIDE) / 4.0, z = (parts[k] - expected) / sqrt(expected * 3 / 4);
        print_message("distances from 2^%d: %d, z %.2f\n", k - 10, parts[k], z);
        assert_true(fabs(z) < ztest_limit(4));
    }
}

/* Large steps propose uniform numbers; of all steps they are the share that is said; small steps go up as
 * often as down. */
static void test_proposals(void **state) {
    (void)state;
    enum { BINS = 64 };
    double counts[2][BINS] = {{0}}, chi2[2] = {0}, large = 0, up = 0, small = 0;
    evaluate("#include \"sequence/chain_step.glsl\"\n"
             "vec4 evaluate(vec2 texel) {\n"
             "    ChainStep step = chain_step(uint(texel.x), uint(texel.y), 3u, false);\n"
             "    return vec4(chain_pair(vec2(0.5), step, 2u), step.large ? 1.0 : 0.0, step.threshold);\n"
             "}\n");
    for (int i = 0; i < TEXELS; i++) {
        const float *r = results + 4 * i;
        large += (double)r[2];
        small += r[2] > 0 ? 0 : 1;
        up += r[2] > 0 ? 0 : r[0] > 0.5F;
        for (int k = 0; k < 2 && r[2] > 0; k++) counts[k][(int)(r[k] * BINS)]++;
        assert_true(r[3] >= 0 && r[3] < 1);
    }
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < BINS; i++) chi2[k] += pow(counts[k][i] - large / BINS, 2) / (large / BINS);
        print_message("large steps: chi-square %.1f of %d bins\n", chi2[k], BINS);
        assert_true(fabs(ztest_chi_square(chi2[k], BINS - 1)) < ztest_limit(4));
    }
    print_message("%.4f of the steps are large, %.4f of the others go up\n", large / TEXELS, up / small);
    assert_true(fabs(large / TEXELS - 0.3) < ztest_limit(4) * sqrt(0.3 * 0.7 / TEXELS));
    assert_true(fabs(up / small - 0.5) < ztest_limit(4) * 0.5 / sqrt(small));
}

/* Chains over one pair of numbers, whose paths have the brightness f. From its start on, and after any number
 * of steps, the weight of a chain times g is on average the integral of f g: with f a narrow bright part
 * beside darkness and a slope, and g four quarters. */
static void test_law(void **state) {
    (void)state;
    static const int steps[] = {0, 1, 7, 60};
    static const double wanted[4] = {0.5, 0.1875, 0.5, 0.1875};
    for (int s = 0; s < 4; s++) {
        char glsl[2000];
        snprintf(glsl, sizeof glsl,
                 "#include \"sequence/chain_step.glsl\"\n"
                 "float f(vec2 u) { return u.x < 0.05 ? 20.0 : u.x < 0.5 ? 0.0 : u.x; }\n"
                 "vec4 evaluate(vec2 texel) {\n"
                 "    vec2 at = vec2(0.0);\n"
                 "    float here = 0.0;\n"
                 "    float sum = 0.0;\n"
                 "    for (uint i = 0u; i < %uu; i++) {\n"
                 "        bool starts = i < 16u;\n"
                 "        ChainStep step = chain_step(uint(texel.x) + 256u * uint(texel.y), i, 5u, starts);\n"
                 "        vec2 next = chain_pair(at, step, 0u);\n"
                 "        float there = f(next);\n"
                 "        float chance = starts ? chain_choice(sum, there) : chain_acceptance(here, there);\n"
                 "        sum += starts ? there : 0.0;\n"
                 "        if (step.threshold < chance) { at = next; here = there; }\n"
                 "    }\n"
                 "    float weight = sum / 16.0;\n"
                 "    bool left = at.x < 0.5;\n"
                 "    bool low = at.y < 0.5;\n"
                 "    return weight * vec4(left && low, !left && low, left && !low, !left && !low);\n"
                 "}\n",
                 16U + (unsigned)steps[s]);
        evaluate(glsl);
        for (int k = 0; k < 4; k++) {
            char name[80];
            double sum = 0, squares = 0;
            for (int i = 0; i < TEXELS; i++) {
                double value = (double)results[4 * i + k];
                sum += value / TEXELS;
                squares += value * value / TEXELS;
            }
            snprintf(name, sizeof name, "after %d steps, quarter %d", steps[s], k);
            double variance = (squares - sum * sum) / TEXELS;
            assert_true(sqrt(variance) < 0.02 * wanted[k]);
            assert_true(ztest_difference(name, sum - wanted[k], variance, wanted[k], 16));
        }
    }
}

/* Over the offset, each start is taken as often as its weight says, and for one offset to less than one
 * chain. Chains without light, and weights that are not finite, start none. Without any light each chain
 * keeps its own start. */
static void test_starts(void **state) {
    (void)state;
    enum { COUNT = 7, OFFSETS = 1000 };
    static const float weights[COUNT] = {0, 1, 0.125F, NAN, 5, 0, 0.375F}, none[COUNT] = {0, NAN, -1};
    double taken[COUNT] = {0}, sum = 6.5;
    int sources[COUNT];
    for (int k = 0; k < OFFSETS; k++) {
        int here[COUNT] = {0};
        double mean = chain_starts(weights, COUNT, (k + 0.5) / OFFSETS, sources);
        assert_true(fabs(mean - sum / COUNT) < 1e-12);
        for (int i = 0; i < COUNT; i++) here[sources[i]]++;
        for (int i = 0; i < COUNT; i++) {
            double wanted = isfinite(weights[i]) ? COUNT * (double)weights[i] / sum : 0;
            assert_true(fabs(here[i] - wanted) < 1);
            taken[i] += here[i] / (double)OFFSETS;
        }
    }
    for (int i = 0; i < COUNT; i++) {
        double wanted = isfinite(weights[i]) ? COUNT * (double)weights[i] / sum : 0;
        assert_true(fabs(taken[i] - wanted) < 0.002);
    }
    for (int k = 0; k < 2; k++) {
        assert_true(chain_starts(none, COUNT, k ? 0.999999999 : 0, sources) == 0);
        for (int i = 0; i < COUNT; i++) assert_int_equal(sources[i], i);
        assert_true(chain_starts(weights, COUNT, k ? 0.999999999 : 0, sources) > 0);
        for (int i = 0; i < COUNT; i++) assert_true(weights[sources[i]] > 0);
    }
}

enum { RUNS = 8, PIXELS = 32, TILE = 8, TILES = (PIXELS / TILE) * (PIXELS / TILE), VALUES = TILES + 1 };

/* The means of tiles, and of the whole picture as the last value, by run. */
typedef struct Runs {
    double values[RUNS][VALUES];
} Runs;

static void render_runs(const char *scene, const char *arguments, unsigned first_seed, Runs *runs) {
    static Studio studio;
    memset(runs, 0, sizeof *runs);
    studio_open(&studio, scene, arguments);
    for (int run = 0; run < RUNS; run++) {
        Image image = studio_picture(&studio, first_seed + (unsigned)run);
        for (int i = 0; i < PIXELS * PIXELS; i++) {
            const float *pixel = image.rgba + 4 * i;
            int tile = i / PIXELS / TILE * (PIXELS / TILE) + i % PIXELS / TILE;
            double value = ((double)pixel[0] + (double)pixel[1] + (double)pixel[2]) / 3;
            assert_true(isfinite(value));
            runs->values[run][tile] += value / (TILE * TILE);
            runs->values[run][TILES] += value / (PIXELS * PIXELS);
        }
        image_free(&image);
    }
    studio_close(&studio);
}

static void measure(const Runs *runs, int value, double *mean, double *variance) {
    double sum = 0, squares = 0;
    for (int i = 0; i < RUNS; i++) sum += runs->values[i][value] / RUNS;
    for (int i = 0; i < RUNS; i++) squares += pow(runs->values[i][value] - sum, 2);
    *mean = sum;
    *variance = squares / (RUNS - 1) / RUNS;
}

/* The tiles of a chain's picture depend on each other, but its runs do not. So each value is held against
 * Student's t by its own runs, and the rate of false alarms is shared by all of them. */
static void expect_same_means(const char *name, const Runs *got, const Runs *wanted, long comparisons) {
    double worst = 1, mean[2] = {0}, variance[2] = {0};
    for (int i = 0; i < VALUES; i++) {
        measure(got, i, &mean[0], &variance[0]);
        measure(wanted, i, &mean[1], &variance[1]);
        double both = variance[0] + variance[1], difference = mean[0] - mean[1];
        if (!(both > 0)) continue;
        /* Welch's degrees of freedom. */
        double freedom = both * both * (RUNS - 1) / (variance[0] * variance[0] + variance[1] * variance[1]);
        worst = fmin(worst, ztest_student_tail(fabs(difference) / sqrt(both), freedom));
    }
    double error = sqrt(variance[0] + variance[1]) / mean[1];
    print_message("%s: mean off by %+.2f %% +- %.2f %%; the least likely of %d values has p = %.1e\n", name,
                  100 * (mean[0] / mean[1] - 1), 100 * error, VALUES, worst);
    assert_true(support_block() > 1 || error < 0.03);
    assert_true(worst * VALUES * (double)comparisons > ZTEST_ALARM);
}

static const char *const same_scenes[][2] = {
    {"scenes/crater.glsl", "--light cosine"},
    {"scenes/crater.glsl", "--light control --sun 5,90"},
    {"scenes/crater.glsl", "--sun-disk=sampled --sun 30"},
    {"scenes/house.glsl", "--sun 30"},
    {"scenes/house.glsl", "--light mis --sun 60"},
    {"scenes/materials.glsl", ""},
    {"tests/data/glass.glsl", "--sun-disk=sampled --set sun.radius=10"},
    {"tests/data/window_room.glsl", "--light portal"},
    {"scenes/gyroid.glsl", ""},
    {"scenes/box-room.glsl", ""},
};

static void test_same_means(void **state) {
    (void)state;
    enum { COUNT = sizeof same_scenes / sizeof *same_scenes };
    static Runs chains, independent;
    for (int i = 0; i < COUNT; i++) {
        char arguments[256], name[200];
        snprintf(name, sizeof name, "%s %s", same_scenes[i][0], same_scenes[i][1]);
        snprintf(arguments, sizeof arguments, "--size 32x32 --spp 512 --sequence metropolis %s",
                 same_scenes[i][1]);
        render_runs(same_scenes[i][0], arguments, 0, &chains);
        snprintf(arguments, sizeof arguments, "--size 32x32 --spp 1024 --sequence random %s",
                 same_scenes[i][1]);
        render_runs(same_scenes[i][0], arguments, 100, &independent);
        expect_same_means(name, &chains, &independent, COUNT);
    }
}

/* In a white furnace every mean is 1. */
static void test_furnace(void **state) {
    (void)state;
    static Runs chains, one;
    for (int i = 0; i < RUNS; i++)
        for (int k = 0; k < VALUES; k++) one.values[i][k] = 1;
    render_runs("scenes/furnace.glsl", "--size 32x32 --spp 512 --sequence metropolis --sky uniform", 0,
                &chains);
    expect_same_means("furnace", &chains, &one, 1);
}

static void expect_same_bits(const char *a, const char *b) {
    Image images[2];
    Error error;
    for (int i = 0; i < 2; i++)
        if (!image_read(&images[i], i ? b : a, &error)) fail_msg("%s", error.text);
    assert_memory_equal(images[0].rgba, images[1].rgba,
                        (size_t)images[0].width * (size_t)images[0].height * 4 * sizeof(float));
    for (int i = 0; i < 2; i++) image_free(&images[i]);
}

/* Any number of threads makes the same picture. */
static void test_threads(void **state) {
    (void)state;
    const char *a = support_path("a.pfm"), *b = support_path("b.pfm");
    const char *options = "scenes/house.glsl --size 40x30 --spp 24 --sun-disk --sequence metropolis --quiet";
    for (int i = 0; i < 2; i++) {
        if (support_run(i ? "LP_NUM_THREADS=1" : "LP_NUM_THREADS=2", "render %s -o '%s'", options, i ? b : a))
            fail_msg("%s", support_err);
    }
    expect_same_bits(a, b);
}

/* However the work is cut into groups, draws and steps, the picture is the same, and the film counts a path
 * for each sample of each pixel. */
static void test_cuts(void **state) {
    (void)state;
    Context context;
    Renderer renderer;
    Scene scene;
    Error error;
    Image whole, cut;
    FilmCount count;
    support_open(&context);
    assert_true(scene_read(&scene, "scenes/crater.glsl", "glsl", &error));
    RenderParams params = {.scene = &scene, .sequence = "metropolis", .width = 48, .height = 32};
    if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    while (renderer.film.samples < 600)
        assert_true(renderer_pass(&renderer, 600 - renderer.film.samples, NULL, &error));
    assert_true(film_read(&renderer.film, &whole, &count, &error));
    assert_int_equal(count.accepted, 600 * 48 * 32);
    assert_true(renderer.film.light_paths >= 600 * 48 * 32);
    int calls = 0;
    film_reset(&renderer.film);
    for (; renderer.film.samples < 600; calls++) {
        uint64_t left = 600 - renderer.film.samples;
        assert_true(renderer_advance(&renderer, left, calls % 3 ? 1e-5 : 5e-3, NULL, &error));
    }
    assert_true(film_read(&renderer.film, &cut, &count, &error));
    print_message("%d calls, %.0f paths\n", calls, renderer.film.light_paths);
    assert_true(calls > 100);
    assert_memory_equal(whole.rgba, cut.rgba, 4 * 48 * 32 * sizeof(float));
    image_free(&whole);
    image_free(&cut);
    renderer_destroy(&renderer);
    scene_destroy(&scene);
    context_close(&context);
}

static Image picture_of(Renderer *renderer) {
    Image image;
    FilmCount count;
    Error error;
    while (renderer->film.samples < 32)
        assert_true(renderer_pass(renderer, 32 - renderer->film.samples, NULL, &error));
    assert_true(film_read(&renderer->film, &image, &count, &error));
    return image;
}

/* A renderer that starts anew, with another size, seed and sun, makes the picture of a new one. */
static void test_restart(void **state) {
    (void)state;
    Context context;
    Renderer renderer, fresh;
    Scene scene;
    Error error;
    support_open(&context);
    assert_true(scene_read(&scene, "scenes/crater.glsl", "glsl", &error));
    RenderParams params = {.scene = &scene, .sequence = "metropolis", .width = 64, .height = 48};
    if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    Image before = picture_of(&renderer);
    params.width = 80;
    params.seed = 7;
    scene_set_sun(&scene, 40, 100);
    if (!renderer_restart(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    if (!renderer_create(&fresh, &context, &params, &error)) fail_msg("%s", error.text);
    Image again = picture_of(&renderer), wanted = picture_of(&fresh);
    assert_memory_equal(again.rgba, wanted.rgba, 4 * 80 * 48 * sizeof(float));
    assert_memory_not_equal(again.rgba, before.rgba, 4 * 64 * 48 * sizeof(float));
    image_free(&before);
    image_free(&again);
    image_free(&wanted);
    renderer_destroy(&renderer);
    renderer_destroy(&fresh);
    scene_destroy(&scene);
    context_close(&context);
}

static double mean_of(const char *path) {
    Image image;
    Error error;
    double sum = 0;
    if (!image_read(&image, path, &error)) fail_msg("%s", error.text);
    int pixels = image.width * image.height;
    for (int i = 0; i < 4 * pixels; i++) {
        assert_true(isfinite(image.rgba[i]));
        sum += i % 4 < 3 ? (double)image.rgba[i] / (3 * pixels) : 0;
    }
    image_free(&image);
    return sum;
}

/* Another driver rounds in another way, so that some chains decide otherwise, and few of them. */
static void test_another_driver(void **state) {
    (void)state;
    const char *a = support_path("llvmpipe.pfm"), *b = support_path("softpipe.pfm");
    for (int soft = 0; soft < 2; soft++) {
        if (support_run(
                soft ? "GALLIUM_DRIVER=softpipe LIBGL_ALWAYS_SOFTWARE=1" : "",
                "render scenes/crater.glsl --size 16x16 --spp 64 --sequence metropolis --quiet -o '%s'",
                soft ? b : a))
            skip();
    }
    double difference = mean_of(b) / mean_of(a) - 1;
    print_message("another driver's mean is off by %+.2e\n", difference);
    assert_true(fabs(difference) < 1e-3);
}

/* A scene without light is black, and so is one of which the chains find none. */
static void test_black(void **state) {
    (void)state;
    const char *out = support_path("black.pfm");
    support_expect(0, "",
                   "render scenes/crater.glsl --size 16x16 --spp 32 --sky uniform:0 --quiet "
                   "--sequence metropolis -o '%s'",
                   out);
    assert_true(mean_of(out) == 0);
}

/* No error is told or promised, and what needs it is refused; the rest of the command works as ever. */
static void test_refused(void **state) {
    (void)state;
    const char *out = support_path("refused.exr");
    static const char *const refused[][2] = {
        {"--error 5", "say how long by --spp N or --time SECONDS in place of --error"},
        {"", "say how long by --spp N or --time SECONDS"},
        {"--spp 4 --aov variance", "--aov variance: the paths of --sequence metropolis depend"},
        {"--spp 4 --sun-disk=traced", "--sun-disk traced: light paths cannot be traced beside the chains"},
    };
    for (int i = 0; i < 4; i++)
        support_expect(2, refused[i][1],
                       "render scenes/materials.glsl --size 8x8 --sequence metropolis %s -o '%s'",
                       refused[i][0], out);
    support_expect(0, "sun disk sampled",
                   "render scenes/materials.glsl --size 16x16 --spp 16 --sun-disk --sequence metropolis -v "
                   "--aov albedo,samples -o '%s'",
                   out);
    assert_null(strstr(support_out, "estimated error"));
    assert_null(strstr(support_out, "from the sun"));
    support_expect(
        0, "\"done\": true",
        "render scenes/crater.glsl --size 16x16 --time 0.5 --sequence metropolis --progress json -o "
        "'%s'",
        out);
    assert_true(support_figure("samples") >= 16 && support_figure("error_percent") < 0);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moves),      cmocka_unit_test(test_proposals),
        cmocka_unit_test(test_law),        cmocka_unit_test(test_starts),
        cmocka_unit_test(test_same_means), cmocka_unit_test(test_furnace),
        cmocka_unit_test(test_threads),    cmocka_unit_test(test_cuts),
        cmocka_unit_test(test_restart),    cmocka_unit_test(test_another_driver),
        cmocka_unit_test(test_black),      cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests_name("metropolis", tests, support_folder, support_clean);
}
