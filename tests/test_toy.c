/* Files that paint their pictures by themselves, in `render`. Each file of tests/data/toys says in its
 * comments what to expect of it at 40x30 pixels and iTime 2:
 *
 *     // expect X Y: R G B     a pixel's colour, from the bottom left corner
 *     // warns WORDS           standard error has these words
 *     // refused WORDS         it is refused with these words
 */
#include "support.h"
#include "toys.h"

#include "base/clock.h"
#include "base/file.h"
#include "image/tone.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define AS_SAID "--size 40x30 --set time=2"

static Image read_picture(const char *name) {
    Image image;
    Error error;
    if (!image_read(&image, support_path(name), &error)) fail_msg("%s", error.text);
    return image;
}

/* Where a toy is wrong, the words say so. */
static void check_warnings(const char *toy) {
    bool any = false;
    char words[300];
    for (int i = 0; toys_line(toy, "warns", i, words, sizeof words); i++) {
        any = true;
        if (!strstr(support_err, words)) fail_msg("%s: no '%s' in: %s", toy, words, support_err);
    }
    if (!any && strstr(support_err, "warning")) fail_msg("%s: %s", toy, support_err);
}

static void check_toy(const char *toy) {
    char words[300];
    if (toys_line(toy, "refused", 0, words, sizeof words)) {
        support_expect(3, words, "render %s " AS_SAID " -o '%s'", toy, support_path("a.png"));
        return;
    }
    support_expect(0, "", "render %s " AS_SAID " -o '%s' -o '%s'", toy, support_path("a.png"),
                   support_path("a.exr"));
    check_warnings(toy);
    Image shown = read_picture("a.png"), written = read_picture("a.exr");
    assert_true(toys_check(toy, &shown) == toys_check(toy, &written));
    image_free(&shown);
    image_free(&written);
}

static void need_gl(void) {
    Context context;
    support_open(&context);
    context_close(&context);
}

/* Every file has something to be judged by. */
static void test_toys(void **state) {
    (void)state;
    char words[300];
    int count = 0;
    need_gl();
    for (const char *toy; (toy = toys_next()); count++) {
        if (!toys_line(toy, "expect", 0, words, sizeof words) &&
            !toys_line(toy, "refused", 0, words, sizeof words) &&
            !toys_line(toy, "warns", 0, words, sizeof words))
            fail_msg("%s: expects nothing", toy);
        check_toy(toy);
    }
    assert_true(count >= 30);
}

/* Mesa can set variables to 0 by itself: no picture changes by that. */
static void test_zero(void **state) {
    (void)state;
    char words[300];
    need_gl();
    for (const char *toy; (toy = toys_next());) {
        if (toys_line(toy, "refused", 0, words, sizeof words)) continue;
        support_expect(0, "", "render %s " AS_SAID " -o '%s'", toy, support_path("own.pfm"));
        assert_int_equal(support_run("glsl_zero_init=true", "render %s " AS_SAID " -o '%s'", toy,
                                     support_path("mesa.pfm")),
                         0);
        Text own = {0}, mesa = {0};
        Error error;
        assert_true(file_read(support_path("own.pfm"), STATUS_FAILURE, &own, &error));
        assert_true(file_read(support_path("mesa.pfm"), STATUS_FAILURE, &mesa, &error));
        if (own.size != mesa.size || memcmp(own.data, mesa.data, own.size) != 0)
            fail_msg("%s: a variable is not 0", toy);
        text_free(&own);
        text_free(&mesa);
    }
}

/* What is about light is refused, by name. */
static void test_options(void **state) {
    (void)state;
    static const char *const useless[] = {
        "--error 2",          "--time 1",           "--seed 1",
        "--depth 3",          "--aov depth",        "--sun 3",
        "--sun-disk",         "--orders 2",         "--atmosphere earth",
        "--sky table",        "--light cosine",     "--further harmonics:8",
        "--sequence random",  "--exposure 1",       "--tone author",
        "--set sun.radius=1", "--set camera.fov=9", "--set atmosphere.mie=0"};
    for (size_t i = 0; i < sizeof useless / sizeof *useless; i++) {
        char name[40];
        int start = strncmp(useless[i], "--set ", 6) == 0 ? 6 : 0;
        snprintf(name, sizeof name, "magichour: %.*s", (int)strcspn(useless[i] + start, " =") + start,
                 useless[i]);
        support_expect(2, name, "render tests/data/toys/plain.glsl -o '%s' %s", support_path("a.exr"),
                       useless[i]);
    }
    support_expect(2, "only `render` and `view`", "explain tests/data/toys/plain.glsl");
    support_expect(2, "only `render` and `view`", "chart tests/data/toys/plain.glsl -o '%s'",
                   support_path(""));
}

/* A program of somebody's with tabs: Common is in front of both, and Image gets what Buffer A drew for the
 * same frame. */
static void test_tabs(void **state) {
    (void)state;
    need_gl();
    const char *folder = support_path("tabs");
    char command[700];
    snprintf(command, sizeof command, "mkdir -p '%s'", folder);
    assert_int_equal(system(command), 0);
    support_write("tabs/common.glsl", "const float STEP = 0.125;\n");
    support_write("tabs/buffer-a.glsl", "void mainImage(out vec4 c, in vec2 p) {\n"
                                        "    c = texelFetch(iChannel0, ivec2(p), 0) + STEP;\n}\n");
    support_write("tabs/image.glsl", "#include \"common.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) {\n"
                                     "    c = vec4(texelFetch(iChannel0, ivec2(p), 0).rgb, 1.0);\n"
                                     "    if (p.x < 4.0) c = vec4(iTime, STEP, 0.0, 1.0);\n}\n");
    support_expect(0, "", "render '%s' --size 8x8 --frames 4 -o '%s'", folder, support_path("tabs.exr"));
    Image image = read_picture("tabs.exr");
    assert_true(image.rgba[4 * 7] == 0.5f);
    assert_true(fabsf(image.rgba[0] - 0.05f) < 1e-6f && image.rgba[1] == 0.125f);
    image_free(&image);
    support_expect(0, "", "render '%s/' --size 8x8 -o '%s'", folder, support_path("tabs.exr"));
    image = read_picture("tabs.exr");
    assert_true(image.rgba[4 * 7] == 0.125f && image.rgba[0] == 0.0f);
    image_free(&image);
    support_write("tabs/buffer-a.glsl", "void mainImage(out vec4 c, in vec2 p) {\n    c = nothing;\n}\n");
    support_expect(3, "tabs/buffer-a.glsl:2: ", "render '%s' --size 8x8 -o '%s'", folder,
                   support_path("tabs.exr"));
    support_expect(2, "which has no frames", "render scenes/crater.glsl --frames 3 -o '%s'",
                   support_path("tabs.exr"));
}

/* A text that brings its own Ray paints by itself, also if it has functions of a scene's names. */
static void test_own_world(void **state) {
    (void)state;
    need_gl();
    const char *toy = support_write("world.glsl", "struct Ray {\n    vec3 origin;\n};\n"
                                                  "float scene_intersect(Ray ray) { return ray.origin.x; }\n"
                                                  "void mainImage(out vec4 c, in vec2 p) {\n"
                                                  "    c = vec4(scene_intersect(Ray(vec3(0.25))));\n}\n");
    support_expect(0, "", "render '%s' --size 8x8 -o '%s'", toy, support_path("a.exr"));
    Image image = read_picture("a.exr");
    assert_true(image.rgba[0] == 0.25f);
    image_free(&image);
}

#define HALF                                                                                                 \
    "void mainImage(out vec4 c, in vec2 p) {\n"                                                              \
    "    c = vec4(p.x < 8.5 ? 1.0 : 0.0, p.y / 16.0, iMouse.x / 255.0, 1.0);\n}\n"

/* The samples of a pixel fill it evenly. One sample lies in the middle. */
static void test_samples(void **state) {
    (void)state;
    need_gl();
    const char *toy = support_write("half.glsl", HALF);
    support_expect(0, "", "render '%s' --size 16x16 --spp 256 -o '%s'", toy, support_path("a.exr"));
    Image many = read_picture("a.exr");
    const float *middle = many.rgba + 4 * (7 * 16 + 8);
    assert_true(fabsf(middle[0] - 0.5f) < 0.02f && fabsf(middle[1] - 8.5f / 16) < 1e-3f && middle[2] == 0.0f);
    assert_true(middle[-4] == 1.0f && middle[4] == 0.0f);
    support_expect(0, "", "render '%s' --size 16x16 --set mouse=51,0,0,0 -o '%s'", toy,
                   support_path("b.exr"));
    Image one = read_picture("b.exr");
    assert_true(one.rgba[4 * (7 * 16 + 8)] == 0.0f && fabsf(one.rgba[4 * (7 * 16 + 8) + 2] - 0.2f) < 1e-6f);
    image_free(&many);
    image_free(&one);
}

/* Colours that are no numbers are not passed over. */
static void test_no_numbers(void **state) {
    (void)state;
    need_gl();
    const char *toy = support_write("nan.glsl", "void mainImage(out vec4 c, in vec2 p) {\n"
                                                "    c = vec4(p.x < 4.0 ? log(-p.x) : 0.5); }\n");
    support_expect(0, "25 % of the pixels have a colour that is no finite number",
                   "render '%s' --size 16x16 -o '%s'", toy, support_path("a.exr"));
}

/* While there is nothing to save, a signal ends the program at once, also in the middle of a compilation that
 * takes seconds. */
static void test_interrupt(void **state) {
    (void)state;
    need_gl();
    const char *program = getenv("MAGICHOUR"), *toy = toys_write_slow("slow.glsl"),
               *scene = toys_write_slow_scene("slow-scene.glsl");
    const char *const ways[][2] = {{"render", toy}, {"render", scene}, {"explain", scene}, {"chart", scene}};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        char command[2048];
        bool writes = strcmp(ways[i][0], "explain") != 0;
        snprintf(command, sizeof command,
                 "timeout --preserve-status -s %s 1 '%s' %s '%s' --size 64x64 %s%s >/dev/null 2>&1; exit $?",
                 i % 2 ? "INT" : "TERM", program ? program : "build/magichour", ways[i][0], ways[i][1],
                 writes ? "-o " : "",
                 !writes                            ? ""
                 : strcmp(ways[i][0], "chart") == 0 ? support_path("charts")
                                                    : support_path("slow.exr"));
        double start = clock_seconds();
        int status = WEXITSTATUS(system(command));
        double took = clock_seconds() - start;
        /* A GPU may be done by then. */
        if (status != 130 || took > 1.5)
            print_message("%s: status %d after %.1f s\n", ways[i][0], status, took);
        /* The compilation takes more than four seconds. */
        assert_true(took < 3.5 && (status == 130 || took < 1));
    }
    assert_int_not_equal(access(support_path("slow.exr"), F_OK), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_toys),       cmocka_unit_test(test_zero),
                                       cmocka_unit_test(test_options),    cmocka_unit_test(test_samples),
                                       cmocka_unit_test(test_no_numbers), cmocka_unit_test(test_tabs),
                                       cmocka_unit_test(test_own_world),  cmocka_unit_test(test_interrupt)};
    return cmocka_run_group_tests_name("toy", tests, support_folder, support_clean);
}
