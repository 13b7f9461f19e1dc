/* Light that is traced from the sun: where its paths begin, and that its pictures are those of paths from the
 * camera. */
#include "failed.h"
#include "spread.h"
#include "support.h"

#include "render/aim.h"
#include "render/renderer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double random_unit(void) {
    static uint32_t state = 1;
    state = state * 747796405U + 2891336453U;
    return (double)(state >> 8) / 16777216.0;
}

/* Walks the tree to the leaves, adds up their areas, and fails where a box has none. */
static double leaf_areas(const Aim *aim, int node, const double box[4]) {
    if (node >= AIM_NODES) {
        double area = (box[2] - box[0]) * (box[3] - box[1]);
        assert_true(area > 0);
        return area;
    }
    const float *texel = aim->nodes[node];
    int axes = (int)texel[3];
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        double part[4], cuts[2] = {(double)texel[0], (double)texel[1 + i / 2]};
        int axis[2] = {axes & 1, axes >> (1 + i / 2) & 1}, upper[2] = {i / 2, i % 2};
        memcpy(part, box, sizeof part);
        for (int k = 0; k < 2; k++) part[axis[k] + (upper[k] ? 0 : 2)] = cuts[k];
        sum += leaf_areas(aim, 4 * node + 1 + i, part);
    }
    return sum;
}

static void expect_whole(const Aim *aim) {
    double area = (aim->box[2] - aim->box[0]) * (aim->box[3] - aim->box[1]);
    assert_true(aim->any);
    assert_true(fabs(leaf_areas(aim, 0, aim->box) / area - 1) < 1e-6);
}

/* The leaves are the rectangle, whatever the places are: spread, one, all the same, in a line, none, or no
 * numbers. */
static void test_tree(void **state) {
    (void)state;
    enum { COUNT = 3000 };
    static float places[4 * COUNT], none[8] = {NAN, 0, 0, 1, 0, INFINITY, 0, 1};
    Aim *aim = malloc(sizeof *aim);
    for (int kind = 0; kind < 4; kind++) {
        for (int i = 0; i < COUNT; i++) {
            float *p = places + 4 * i;
            p[0] = kind == 1 ? 5 : (float)pow(random_unit(), 3);
            p[1] = kind == 1 || kind == 2 ? -7 : (float)(1e4 * random_unit());
            p[2] = (float)random_unit();
            p[3] = (float)(kind == 3 ? i % 2 : 1);
        }
        aim_begin(aim, places, COUNT, 0.005);
        expect_whole(aim);
        aim_begin(aim, places + 4, 1, 0.005);
        expect_whole(aim);
        aim_improve(aim, places, COUNT);
        expect_whole(aim);
    }
    aim_begin(aim, none, 2, 0.005);
    assert_false(aim->any);
    memset(places, 0, sizeof places);
    aim_begin(aim, places, COUNT, 0.005);
    assert_false(aim->any);
    free(aim);
}

/* The mean of g / density over the points that are drawn is the integral of g over the rectangle: of 1, of
 * each coordinate and of a corner. Where the places are, there are more points. */
static void test_density(void **state) {
    (void)state;
    enum { SIDE = 256, PLACES = 4000 };
    static const char glsl[] =
        "#include \"sun/aim.glsl\"\n#include \"math/hash.glsl\"\n"
        "vec3 sun_radiance(vec3 d) { return vec3(0.0); }\nvec3 sun_point(vec2 u) { return vec3(0.0, 1.0, "
        "0.0); }\n"
        "float sun_solid_angle() { return 1.0; }\nvec3 sun_middle() { return vec3(0.0, 1.0, 0.0); }\n"
        "vec3 sun_irradiance() { return vec3(0.0); }\nfloat sun_near_solid_angle() { return 1.0; }\n"
        "bool sun_is_near(vec3 d) { return false; }\n"
        "uniform sampler2D inputs;\n"
        "vec4 aim_node(int i) { return texelFetch(inputs, ivec2(i % 256, i / 256), 0); }\n"
        "vec4 aim_rectangle() { return texelFetch(inputs, ivec2(0, 255), 0); }\n"
        "float aim_top() { return 0.0; }\nfloat aim_plane() { return 0.0; }\n"
        "vec4 evaluate(vec2 texel) {\n"
        "    uvec3 h = hash_3(uvec3(uint(texel.x), uint(texel.y), 7u));\n"
        "    vec2 at = aim_sample(vec2(unit_float(h.x), unit_float(h.y)), unit_float(h.z));\n"
        "    return vec4(at, aim_density_at(at), aim_density_at(at + vec2(1.0e6, 0.0)));\n}\n";
    static float places[4 * PLACES], inputs[4 * SIDE * SIDE], results[4 * SIDE * SIDE];
    Aim *aim = malloc(sizeof *aim);
    Context context;
    support_open(&context);
    for (int i = 0; i < PLACES; i++) {
        double turn = 2 * acos(-1) * random_unit(), far = sqrt(random_unit());
        places[4 * i] = (float)(3 + (i % 2 ? 0.3 : 0.02) * far * cos(turn));
        places[4 * i + 1] = (float)((i % 2 ? 0 : 2) + 0.3 * far * sin(turn));
        places[4 * i + 3] = 1;
    }
    aim_begin(aim, places, PLACES, 0.005);
    memcpy(inputs, aim->nodes, sizeof aim->nodes);
    const double *b = aim->box;
    for (int c = 0; c < 4; c++) inputs[4 * SIDE * (SIDE - 1) + c] = (float)b[c];
    support_evaluate(&context, glsl, inputs, SIDE, SIDE, results);
    double sums[4] = {0}, squares[4] = {0}, area = (b[2] - b[0]) * (b[3] - b[1]);
    int inside = 0, n = SIDE * SIDE;
    for (int i = 0; i < n; i++) {
        const float *r = results + 4 * i;
        double x = ((double)r[0] - b[0]) / (b[2] - b[0]), y = ((double)r[1] - b[1]) / (b[3] - b[1]);
        const double g[4] = {1, x, y, x < 0.3 && y > 0.6};
        assert_true(x >= 0 && x < 1.000001 && y >= 0 && y < 1.000001 && r[2] > 0 && r[3] == 0);
        inside += hypot((double)r[0] - 3, (double)r[1]) < 0.3;
        for (int k = 0; k < 4; k++) {
            double value = g[k] / (double)r[2] / area;
            sums[k] += value / n;
            squares[k] += value * value / n;
        }
    }
    static const double wanted[4] = {1, 0.5, 0.5, 0.3 * 0.4};
    for (int k = 0; k < 4; k++) {
        double error = sqrt((squares[k] - sums[k] * sums[k]) / n);
        print_message("integral %d: %.4f +- %.4f, expected %.4f\n", k, sums[k], error, wanted[k]);
        assert_true(fabs(sums[k] - wanted[k]) < 4 * error && error < 0.03);
    }
    assert_true(inside > 0.4 * n);
    context_close(&context);
    free(aim);
}

/* Glass, rough metal, the author's material and mirrors with names and without, in the sun's light of a wide
 * disk. */
static void test_thrown(void **state) {
    (void)state;
    static const char *const others[] = {"--sun-disk=traced --sequence random",
                                         "--sun-disk=traced --sequence sobol"};
    static const char *const places[] = {"--sun 50,90", "--sun 20,250"};
    static Spread chance, traced;
    ZTest pools[2] = {{0}};
    char arguments[256];
    for (int p = 0; p < 2; p++) {
        snprintf(arguments, sizeof arguments,
                 "--size 64x64 --spp 512 --light cosine --sequence random --sun-disk=chance %s", places[p]);
        spread_render("tests/data/thrown.glsl", arguments, 0, &chance);
        for (int k = 0; k < 2; k++) {
            snprintf(arguments, sizeof arguments, "--size 64x64 --spp 512 --light cosine %s %s", others[k],
                     places[p]);
            spread_render("tests/data/thrown.glsl", arguments, 100, &traced);
            spread_expect_same(others[k], &traced, &chance, 4, &pools[k]);
        }
    }
    for (int k = 0; k < 2; k++) spread_expect_pool(others[k], &pools[k]);
}

/* The means and the mean z^2 of blocks of 8x8 pixels against an independent program's picture. Blocks with
 * glass in them are left out, because neither program's standard errors hold there: what is seen through
 * glass is found by luck. */
static void compare_with_another(const char *name, double ball_x, double ball_y, double ball_radius) {
    enum { SIDE = 128, BLOCK = 8 };
    static Spread ours;
    Image reference, se;
    Error error;
    char scene[80], path[2][80];
    double mean = 0, wanted = 0, squares = 0;
    int blocks = 0;
    snprintf(scene, sizeof scene, "tests/data/%s.glsl", name);
    for (int i = 0; i < 2; i++)
        snprintf(path[i], sizeof path[i], "tests/data/%s_traced%s.exr", name, i ? "_se" : "");
    spread_render(scene, "--set atmosphere.rayleigh=0 --set atmosphere.mie=0 --spp 256", 0, &ours);
    if (!image_read(&reference, path[0], &error) || !image_read(&se, path[1], &error))
        fail_msg("%s", error.text);
    for (int at = 0; at < SIDE / BLOCK * (SIDE / BLOCK); at++) {
        int left = at % (SIDE / BLOCK) * BLOCK, top = at / (SIDE / BLOCK) * BLOCK;
        if (hypot(left + BLOCK / 2 - ball_x, top + BLOCK / 2 - ball_y) < ball_radius + BLOCK) continue;
        double difference = 0, variance = 0;
        for (int k = 0; k < 3 * BLOCK * BLOCK; k++) {
            int pixel = (top + k / 3 / BLOCK) * SIDE + left + k / 3 % BLOCK, value = 3 * pixel + k % 3;
            double theirs = (double)reference.rgba[4 * pixel + k % 3],
                   own = (double)se.rgba[4 * pixel + k % 3];
            mean += ours.mean[value];
            wanted += theirs;
            difference += ours.mean[value] - theirs;
            /* A pixel's channels share their paths. */
            variance += 3 * (own * own + ours.variance[value]);
        }
        squares += difference * difference / variance;
        blocks++;
    }
    print_message("%s: mean off by %+.3f %%, mean z^2 of %d blocks %.2f\n", name, 100 * (mean / wanted - 1),
                  blocks, squares / blocks);
    assert_true(blocks > 100 && fabs(mean / wanted - 1) < 0.0015 && squares / blocks < 1.5);
    image_free(&reference);
    image_free(&se);
}

static void test_another_program(void **state) {
    (void)state;
    if (support_block() > 1) skip();
    compare_with_another("glass", 76, 61, 26);
}

static void render(const char *environment, const char *options, const char *path) {
    int status = support_run(environment, "render tests/data/thrown.glsl --size 40x30 --spp 24 %s -o '%s'",
                             options, path);
    if (status) fail_msg("%s", support_err);
}

static void expect_same_bits(const char *a, const char *b) {
    Image images[2];
    Error error;
    for (int i = 0; i < 2; i++)
        if (!image_read(&images[i], i ? b : a, &error)) fail_msg("%s", error.text);
    assert_memory_equal(images[0].rgba, images[1].rgba, 40 * 30 * 4 * sizeof(float));
    for (int i = 0; i < 2; i++) image_free(&images[i]);
}

/* The picture is the same to the bit for any number of threads, and a scene without glass, metal and unnamed
 * mirrors has the same one whether light is traced or not. */
static void test_same(void **state) {
    (void)state;
    const char *a = support_path("a.pfm"), *b = support_path("b.pfm");
    render("", "", a);
    render("LP_NUM_THREADS=1", "", b);
    expect_same_bits(a, b);
    for (int traced = 0; traced < 2; traced++)
        support_expect(0, "", "render scenes/crater.glsl --size 40x30 --spp 16 --quiet --sun-disk=%s -o '%s'",
                       traced ? "traced" : "sampled", traced ? a : b);
    expect_same_bits(a, b);
}

/* However the work is cut into strips and batches, the picture is the same to the bit. */
static void test_cuts(void **state) {
    (void)state;
    static const char *const scenes[] = {"tests/data/thrown.glsl", "scenes/crater.glsl"};
    Context context;
    support_open(&context);
    for (int i = 0; i < 2; i++) {
        Renderer renderer;
        Scene scene;
        Error error;
        Image whole, cut;
        FilmCount count;
        assert_true(scene_read(&scene, scenes[i], "glsl", &error));
        RenderParams params = {.scene = &scene, .width = 40, .height = 30};
        if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
        while (renderer.film.samples < 40)
            assert_true(renderer_pass(&renderer, 40 - renderer.film.samples, NULL, &error));
        assert_true(film_read(&renderer.film, &whole, &count, &error));
        film_reset(&renderer.film);
        int calls = 0;
        for (; renderer.film.samples < 40; calls++) {
            uint64_t left = 40 - renderer.film.samples;
            assert_true(renderer_advance(&renderer, left, calls % 3 ? 1e-5 : 1e-3, NULL, &error));
        }
        assert_true(film_read(&renderer.film, &cut, &count, &error));
        print_message("%s: %d calls, %.0f light paths\n", scenes[i], calls, renderer.film.light_paths);
        assert_true(calls > 10 && (renderer.film.light_paths > 0) == (i == 0));
        assert_true(count.accepted == 40 * 40 * 30);
        assert_memory_equal(whole.rgba, cut.rgba, 4 * 40 * 30 * sizeof(float));
        image_free(&whole);
        image_free(&cut);
        renderer_destroy(&renderer);
        scene_destroy(&scene);
    }
    context_close(&context);
}

/* Another driver, which compiles loops in another way, makes the same picture up to roundings and the
 * branches that they turn. */
static void test_another_driver(void **state) {
    (void)state;
    const char *a = support_path("llvmpipe.pfm"), *b = support_path("softpipe.pfm");
    const char *options = "--size 16x16 --spp 64 --light cosine --set sun.radius=25";
    for (int soft = 0; soft < 2; soft++) {
        const char *environment = soft ? "GALLIUM_DRIVER=softpipe LIBGL_ALWAYS_SOFTWARE=1" : "";
        if (support_run(environment, "render tests/data/thrown.glsl %s --quiet -o '%s'", options,
                        soft ? b : a))
            skip();
    }
    Image images[2];
    Error error;
    double sums[2] = {0};
    for (int i = 0; i < 2; i++) {
        if (!image_read(&images[i], i ? b : a, &error)) fail_msg("%s", error.text);
        for (int k = 0; k < 16 * 16 * 4; k++) sums[i] += k % 4 < 3 ? (double)images[i].rgba[k] : 0;
        image_free(&images[i]);
    }
    print_message("another driver's mean is off by %+.2e\n", sums[1] / sums[0] - 1);
    assert_true(fabs(sums[1] / sums[0] - 1) < 1e-3);
}

/* What can not be traced is refused, or not traced where the program chooses. */
static void test_refused(void **state) {
    (void)state;
    const char *out = support_path("refused.pfm");
    support_expect(2, "--sun-disk traced: light paths cannot be traced with --light paper",
                   "render scenes/materials.glsl --size 8x8 --spp 1 --sun-disk=traced --light paper -o '%s'",
                   out);
    support_expect(0, "sun disk sampled",
                   "render scenes/materials.glsl --size 8x8 --spp 1 --sun-disk --light paper -v -o '%s'",
                   out);
    support_expect(0, "sun disk traced",
                   "render scenes/materials.glsl --size 8x8 --spp 1 --sun-disk -v -o '%s'", out);
    assert_non_null(strstr(support_out, "Mpaths from the sun"));
    support_expect(0, "sun disk sampled",
                   "render scenes/crater.glsl --size 8x8 --spp 1 --sun-disk -v -o '%s'", out);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tree),           cmocka_unit_test(test_density),
        cmocka_unit_test(test_thrown),         cmocka_unit_test(test_another_program),
        cmocka_unit_test(test_same),           cmocka_unit_test(test_cuts),
        cmocka_unit_test(test_another_driver), cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests_name("traced", tests, support_folder, support_clean);
}
