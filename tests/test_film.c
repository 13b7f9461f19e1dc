/* The film, fed with synthetic passes: long means, rejected samples, passes that never were. */
#include "support.h"

#include "gl/film.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void create_pass(const Context *context, const char *body, Program *program) {
    char glsl[2048];
    GlslSource source;
    Error error;
    snprintf(glsl, sizeof glsl,
             "#version 330 core\n#include \"math/dialect.glsl\"\n#include \"pass/scatter.glsl\"\n"
             "uniform uint pass;\nvoid main() { %s }\n",
             body);
    const char *path = support_write("pass.glsl", glsl);
    if (!support_flatten(&source, "glsl", path, NULL, &error) ||
        !program_create(program, &context->gl, &source, &error)) {
        fail_msg("%s", error.text);
    }
    glsl_source_destroy(&source);
    program_use(program);
}

static void run_pass(Film *film, const Program *program, unsigned pass, unsigned samples) {
    program_set_uint(program, "pass", pass);
    film_begin(film, program);
    program_draw(program, 0, 0, film->width, film->height);
    film_commit(film, samples);
}

/* Ten million samples in groups of 16: constants that float cannot add up, a huge value among small ones, and
 * a mean of alternating values. */
static void test_long_mean(void **state) {
    (void)state;
    enum { GROUPS = 625000 };
    Context context;
    Film film;
    Program program;
    Image image;
    FilmCount count;
    Error error;
    support_open(&context);
    create_pass(&context,
                "film_add(vec4(16.0 * 0.3, 16.0 * (pass == 0u ? 1.0e6 : 1.0e-3), pass % 2u == 0u ? 16.0 : "
                "4.8, 16.0), 0.0);",
                &program);
    assert_true(film_create(&film, &context, 2, 2, 0, &error));
    for (unsigned pass = 0; pass < GROUPS; pass++) run_pass(&film, &program, pass, 16);
    assert_true(film_read(&film, &image, &count, &error));
    assert_true(film.samples == 10000000 && count.accepted == 40000000 && count.rejected == 0);
    double group = (double)(float)(16.0f * 0.3f), small = (double)(16.0f * 1.0e-3f), mixed = (double)4.8f;
    double expected[3] = {group / 16, (16e6 + small * (GROUPS - 1)) / 1e7, (16 + mixed) / 32};
    for (int c = 0; c < 3; c++) {
        double relative = (double)image.rgba[c] / expected[c] - 1;
        print_message("mean of 10 million, channel %d: off by %.1e\n", c, relative);
        assert_true(fabs(relative) < 1e-7);
    }
    image_free(&image);
    film_destroy(&film);
    program_destroy(&program);
    context_close(&context);
}

/* A pixel whose samples are all rejected is black with alpha 0; others keep the mean of what was accepted. */
static void test_rejected(void **state) {
    (void)state;
    Context context;
    Film film;
    Program program;
    Image image;
    FilmCount count;
    Error error;
    support_open(&context);
    create_pass(
        &context,
        "float x = floor(gl_FragCoord.x);\n"
        "film_add(x == 0.0 ? vec4(0.0) : vec4(vec3(2.0) * (16.0 - x), 16.0 - x), x == 0.0 ? 16.0 : x);",
        &program);
    assert_true(film_create(&film, &context, 3, 1, 0, &error));
    for (unsigned pass = 0; pass < 10; pass++) run_pass(&film, &program, pass, 16);
    assert_true(film_read(&film, &image, &count, &error));
    assert_true(count.accepted == 10 * (15 + 14) && count.rejected == 10 * (16 + 1 + 2));
    assert_true(image.rgba[0] == 0 && image.rgba[3] == 0);
    assert_true(image.rgba[4] == 2 && image.rgba[7] == 1 && image.rgba[8] == 2);
    image_free(&image);
    film_reset(&film);
    assert_true(film_read(&film, &image, &count, &error));
    assert_true(count.accepted == 0 && film.samples == 0);
    image_free(&image);
    film_destroy(&film);
    program_destroy(&program);
    context_close(&context);
}

/* The variance of the mean from groups of other sizes, one of them empty, against the definition; small
 * beside the mean in one channel, where a sum of squares would have lost it. */
static void test_variance(void **state) {
    (void)state;
    enum { GROUPS = 6 };
    static const double sizes[GROUPS] = {16, 16, 0, 16, 5, 3}, means[GROUPS] = {1, 3, 9, 2.5, 0, 7};
    Context context;
    Film film;
    Program program;
    Error error;
    float rgb[2 * 3], samples[2];
    double sum = 0, count = 0, scatter = 0;
    support_open(&context);
    create_pass(&context,
                "float n = float[6](16, 16, 0, 16, 5, 3)[pass], m = float[6](1, 3, 9, 2.5, 0, 7)[pass];\n"
                "vec4 group = n * vec4(m, 1000.0 + m / 128.0, 5.0, 1.0);\n"
                "if (gl_FragCoord.x > 1.0 && pass > 0u) group = vec4(0.0);\n"
                "film_scatter(group); film_add(group, 0.0);",
                &program);
    assert_true(film_create(&film, &context, 2, 1, FILM_SCATTER, &error));
    assert_true(film_read_variance(&film, rgb, &error));
    assert_true(isnan(rgb[0]));
    for (unsigned pass = 0; pass < GROUPS; pass++) run_pass(&film, &program, pass, 16);
    for (int i = 0; i < GROUPS; i++) sum += sizes[i] * means[i], count += sizes[i];
    for (int i = 0; i < GROUPS; i++) scatter += sizes[i] * pow(means[i] - sum / count, 2);
    double expected = scatter / 4 / count;
    assert_true(film_read_variance(&film, rgb, &error) && film_read_samples(&film, samples, &error));
    assert_true(fabs((double)rgb[0] / expected - 1) < 1e-6);
    assert_true(fabs((double)rgb[1] * 128 * 128 / expected - 1) < 2e-2);
    assert_true(rgb[2] == 0);
    assert_true(samples[0] == 56 && samples[1] == 16);
    for (int c = 3; c < 6; c++) assert_true(isnan(rgb[c])); /* one group only */
    film_destroy(&film);
    program_destroy(&program);
    context_close(&context);
}

/* What is begun and not committed never was, whichever rows it drew. */
static void test_uncommitted(void **state) {
    (void)state;
    Context context;
    Film film;
    Program program;
    Image image;
    FilmCount count;
    Error error;
    support_open(&context);
    create_pass(&context, "film_add(vec4(1.0, 2.0, floor(gl_FragCoord.y), 1.0), 0.0);", &program);
    assert_true(film_create(&film, &context, 4, 8, 0, &error));
    run_pass(&film, &program, 0, 1);
    film_begin(&film, &program);
    program_draw(&program, 0, 0, 4, 3);
    film_begin(&film, &program);
    program_draw(&program, 0, 0, 4, 5);
    program_draw(&program, 0, 5, 4, 3);
    film_commit(&film, 1);
    assert_true(film_read(&film, &image, &count, &error));
    assert_true(count.accepted == 2 * 4 * 8);
    for (int i = 0; i < 4 * 8; i++) {
        assert_true(image.rgba[4 * i] == 1 && image.rgba[4 * i + 1] == 2);
        assert_true(image.rgba[4 * i + 2] == (float)(i / 4)); /* row 0 is the top */
    }
    image_free(&image);
    film_destroy(&film);
    assert_false(film_create(&film, &context, context.max_texture_size + 1, 1, 0, &error));
    program_destroy(&program);
    context_close(&context);
}

/* Only what is finite gets in, whatever the driver thinks of NaN. */
static void test_finite(void **state) {
    (void)state;
    static float results[4 * 8];
    Context context;
    support_open(&context);
    support_evaluate(
        &context,
        "#include \"math/finite.glsl\"\nuniform sampler2D inputs;\n"
        "vec4 evaluate(vec2 t) {\n"
        "    vec3 v[8] = vec3[8](vec3(0), vec3(1, -2, 3e38), vec3(uintBitsToFloat(0x7f800000u), 0, 0),\n"
        "        vec3(0, uintBitsToFloat(0xff800000u), 0), vec3(0, 0, uintBitsToFloat(0x7fc00000u)),\n"
        "        vec3(uintBitsToFloat(0xffffffffu), 1, 1), vec3(1e-40), vec3(-3.4e38));\n"
        "    return vec4(is_finite(v[int(t.x)]) ? 1 : 0);\n}",
        NULL, 8, 1, results);
    static const float expected[8] = {1, 1, 0, 0, 0, 0, 1, 1};
    for (int i = 0; i < 8; i++) assert_true(results[4 * i] == expected[i]);
    context_close(&context);
}

/* Adds `count` points of column, row and one number for the light, which stand for `paths` light paths. */
static void add_light(Film *film, const float (*points)[3], int count, double paths) {
    float lights[16][4] = {{0}};
    assert_true(count <= 16);
    for (int i = 0; i < count; i++) {
        uint32_t bits = 0x40000000U | (uint32_t)points[i][1] << 14 | (uint32_t)points[i][0];
        lights[i][0] = points[i][2], lights[i][1] = 2 * points[i][2], lights[i][2] = -points[i][2];
        memcpy(&lights[i][3], &bits, sizeof bits);
    }
    film_add_light(film, lights[0], count, paths);
}

/* Points of light join the mean of the samples: those of one pixel are added, those beside the
 * picture and those that are not finite are left out, and light paths that reached nothing count. */
static void test_points(void **state) {
    (void)state;
    static const float first[][3] = {
        {0, 0, 1}, {2.5f, 1.9f, 4}, {0.9f, 0.1f, 0.5f}, {16383, 0, 64}, {0, 2, 64}};
    static const float second[][3] = {{2, 1, 8}, {1, 0, INFINITY}, {1, 0, NAN}, {1, 1, 3}, {3, 0, 64}};
    static const double expected[6] = {1.5, 0, 0, 0, 3, 12};
    Context context;
    Film film;
    Program pass;
    Image image;
    FilmCount count;
    FilmPixel pixel;
    Error error;
    support_open(&context);
    create_pass(&context,
                "vec4 group = vec4(16.0, 32.0, 48.0, 16.0); film_scatter(group); film_add(group, 0.0);",
                &pass);
    assert_true(film_create(&film, &context, 3, 2, FILM_SCATTER | FILM_LIGHT, &error));
    for (int round = 0; round < 2; round++) {
        add_light(&film, first, 5, 20);
        run_pass(&film, &pass, 0, 16);
        add_light(&film, second, 5, 44);
        run_pass(&film, &pass, 1, 16);
        film.light_scale = 10;
        assert_true(film_read(&film, &image, &count, &error));
        assert_true(count.accepted == 6 * 32 && count.rejected == 0);
        for (int i = 0; i < 6; i++) {
            static const double colour[3] = {1, 2, -1};
            assert_true(film_read_pixel(&film, i % 3, i / 3, &pixel, &error));
            for (int c = 0; c < 3; c++) {
                double mean = c + 1 + colour[c] * expected[i] * 10 / 64;
                assert_true(image.rgba[4 * i + c] == (float)mean);
                assert_true(pixel.radiance[c] == mean);
            }
            assert_true(image.rgba[4 * i + 3] == 1);
        }
        image_free(&image);
        /* What is forgotten is forgotten, and the second time gives the same. */
        film_reset(&film);
        assert_true(film.light_paths == 0 && film_read(&film, &image, &count, &error));
        for (int i = 0; i < 4 * 6; i++) assert_true(image.rgba[i] == 0);
        image_free(&image);
    }
    film_destroy(&film);
    program_destroy(&pass);
    context_close(&context);
}

int main(void) {
    /* Llvmpipe's threads cost more than they bring on films of a few pixels. */
    setenv("LP_NUM_THREADS", "0", 0);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_long_mean),   cmocka_unit_test(test_rejected), cmocka_unit_test(test_variance),
        cmocka_unit_test(test_uncommitted), cmocka_unit_test(test_finite),   cmocka_unit_test(test_points),
    };
    return cmocka_run_group_tests_name("film", tests, support_folder, support_clean);
}
