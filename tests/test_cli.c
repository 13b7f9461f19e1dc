/* The program as a user meets it: exit statuses, errors with their place, files whole or untouched. */
#include "support.h"

#include "base/file.h"
#include "gl/loops.h"
#include "image/format.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define TINY "--size 16x16 --spp 1 --sky uniform"
#define MATERIAL "Material scene_material(Hit hit) { return material_new(0, vec3(0)); }\n"
#define INTERSECT "void scene_intersect(Ray ray, INOUT(Hit) hit) { }\n"

static bool exists(const char *path) {
    return access(path, F_OK) == 0;
}

static void test_usage(void **state) {
    (void)state;
    const char *out = support_path("out.exr");
    support_expect(2, "which command?", " ");
    support_expect(2, "unknown command 'paint'", "paint");
    support_expect(2, "where to?", "render scenes/crater.glsl");
    support_expect(2, ".exr, .png and .pfm can be written", "render scenes/crater.glsl -o '%s'",
                   support_path("out.jpg"));
    support_expect(2, "unknown method 'frob' (known: auto, gauss, table, paper, uniform)",
                   "render scenes/crater.glsl --sky frob -o '%s'", out);
    support_expect(2, "unknown method 'frob' (known: auto, cosine, control, mis, portal, paper)",
                   "render scenes/crater.glsl --light frob -o '%s'", out);
    support_expect(2, "unknown method 'frob' (known: auto, additive, random, sobol)",
                   "render scenes/crater.glsl --sequence frob -o '%s'", out);
    support_expect(2, "is not paper:NxM", "render scenes/crater.glsl --sky paper:0x4 -o '%s'", out);
    support_expect(2, "is not paper:NxM", "render scenes/crater.glsl --sky paper:4 -o '%s'", out);
    support_expect(2, "--sky uniform: -1 is outside the range from 0",
                   "render scenes/crater.glsl --sky uniform:-1 -o '%s'", out);
    support_expect(2, "is not gauss:n with n from 4 to 12", "render scenes/crater.glsl --sky gauss:3 -o '%s'",
                   out);
    support_expect(2, "a table is filled by gauss or paper",
                   "render scenes/crater.glsl --sky table:uniform -o '%s'", out);
    support_expect(2, "a table is filled by gauss or paper",
                   "render scenes/crater.glsl --sky table:table -o '%s'", out);
    support_expect(2, "--sun-disk: unknown method 'frob' (known: auto, off, sampled, traced, chance)",
                   "render scenes/crater.glsl --sun-disk=frob -o '%s'", out);
    support_expect(2, "takes no numbers", "render scenes/crater.glsl --light cosine:3 -o '%s'", out);
    support_expect(2, "unknown backend 'vulkan' (known: auto, egl, osmesa, glfw)",
                   "render scenes/crater.glsl --backend vulkan -o '%s'", out);
    support_expect(2, "no preset 'dawn' (known: noon, afternoon, sunset, early-evening, twilight)",
                   "render scenes/crater.glsl --preset dawn -o '%s'", out);
    support_expect(
        2, "unknown atmosphere 'mars' (known: simmons2017, simmons2017-author, simmons2017-ozone, earth)",
        "render scenes/crater.glsl --atmosphere mars -o '%s'", out);
    support_expect(2, "--set scenes/crater.glsl has no setting 'frob'",
                   "render scenes/crater.glsl --set frob=1 -o '%s'", out);
    support_expect(2, "--set atmosphere.mie_g: 'nan' is not a number",
                   "render scenes/crater.glsl --set atmosphere.mie_g=nan -o '%s'", out);
    support_expect(2, "must be above atmosphere.planet_radius_m",
                   "render scenes/crater.glsl --set atmosphere.top_radius_m=6e6 -o '%s'", out);
    support_expect(2, "eye is at its target", "render scenes/crater.glsl --set camera.eye=0,0,0 -o '%s'",
                   out);
    support_expect(2, "each side must be from 1 to 16384",
                   "render scenes/crater.glsl --size 100000x100000 -o '%s'", out);
    support_expect(2, "at least 1x1 pixels", "render scenes/crater.glsl --size 0x0 -o '%s'", out);
    support_expect(2, "no pass/trace.glsl there", "render scenes/crater.glsl --glsl-dir /tmp -o '%s'", out);
    assert_false(exists(out));
}

/* A driver that ends all loops after so many iterations does it without an error: what would go past that is
 * refused. Another driver is asked for it and does it. */
static void test_loop_budget(void **state) {
    (void)state;
    static const struct {
        const char *arguments, *needs;
    } cases[] = {
        {"crater.glsl --sky paper:300x300 --light cosine --depth 8",
         "--sky paper:300x300 with --light cosine and 8 surface hits needs 90310 loop iterations a sample; "
         "this OpenGL's limit is "},
        {"crater.glsl --sky paper:300x200 --light control", "needs 123604 loop iterations"},
        {"crater.glsl --depth 100000", "this OpenGL's limit is "},
        {"gyroid.glsl --atmosphere simmons2017 --depth 1000", "this OpenGL's limit is "},
    };
    Context context;
    Error error;
    long limit;
    support_open(&context);
    if (!loops_probe(&context.gl, &limit, &error)) fail_msg("%s", error.text);
    context_close(&context);
    print_message("the limit of loops here: %ld\n", limit);
    assert_true(limit == 0 || limit >= 65535);
    const char *out = support_path("out.exr");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bool refused = limit == 65535;
        support_expect(refused ? 2 : 0, refused ? cases[i].needs : "",
                       "render scenes/%s --size 2x2 --spp 1 --quiet -o '%s'", cases[i].arguments, out);
        assert_int_equal(exists(out), !refused);
        unlink(out);
    }
    support_expect(
        0, "",
        "render scenes/crater.glsl --sky paper:300x200 --light cosine --spp 1 --size 4x4 --quiet -o '%s'",
        support_path("fits.exr"));
}

/* A sum that the budget just admits is whole: with twice the steps a converged sky changes by less than 1 %.
 */
static void test_loop_limit_holds(void **state) {
    (void)state;
    support_expect(
        0, "",
        "render scenes/crater.glsl --size 4x4 --spp 4 --sky paper:1000x60 --depth 8 --light cosine --quiet "
        "--set camera.target=0,3,0 --set camera.fov=20 -o '%s'",
        support_path("limit.pfm"));
    support_expect(
        0, "",
        "render scenes/crater.glsl --size 4x4 --spp 4 --sky paper:500x60 --depth 8 --light cosine --quiet "
        "--set camera.target=0,3,0 --set camera.fov=20 -o '%s'",
        support_path("half.pfm"));
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 1", support_path("limit.pfm"),
                   support_path("half.pfm"));
}

static void test_scene_errors(void **state) {
    (void)state;
    static const struct {
        const char *text, *part;
    } cases[] = {
        {"//@ frob\n" INTERSECT MATERIAL, "bad.glsl:1: unknown annotation 'frob'"},
        {INTERSECT, "bad.glsl:1: missing function: Material scene_material(Hit hit)"},
        {MATERIAL, "bad.glsl:1: missing function: void scene_intersect(Ray ray, INOUT(Hit) hit)"},
        {"// void scene_intersect() {}\n" MATERIAL, "missing function: void scene_intersect"},
        {"#include \"shape/march.glsl\"\n" INTERSECT MATERIAL,
         "bad.glsl:1: missing function: float scene_distance(vec3 p)"},
        {INTERSECT MATERIAL "\nfloat f() { return frob; }\n", "bad.glsl:4: "},
        {INTERSECT "#include \"shape/sphere.glsl\"\n" MATERIAL "\n\nfloat f( { }\n", "bad.glsl:6: "},
        {"#include \"shape/cube.glsl\"\n" INTERSECT MATERIAL, "bad.glsl:1: no file 'shape/cube.glsl'"},
        {"//@ title x\n//@ sky frob\n" INTERSECT MATERIAL, "bad.glsl:2: --sky: unknown method 'frob'"},
        {"", "missing function"},
        {"\x01\x02\x03", "missing function"},
    };
    const char *out = support_path("out.exr");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *scene = support_write("bad.glsl", cases[i].text);
        support_expect(3, cases[i].part, "render '%s' --size 16x16 --spp 1 -o '%s'", scene, out);
    }
    support_expect(3, "none.glsl: cannot be read: No such file", "render none.glsl -o '%s'", out);
    support_expect(3, "scenes: cannot be read: Is a directory", "render scenes -o '%s'", out);
    assert_false(exists(out));
}

/* The driver's complaint about a file that the scene includes names that file. */
static void test_included_error(void **state) {
    (void)state;
    support_write("part.glsl", "\n\nfloat part() { return vec3(1.0); }\n");
    const char *scene = support_write("whole.glsl", "#include \"part.glsl\"\n" INTERSECT MATERIAL);
    support_expect(3, "part.glsl:3: ", "render '%s' " TINY " -o '%s'", scene, support_path("out.exr"));
}

static void test_outputs(void **state) {
    (void)state;
    Error error;
    const char *old = support_path("old.exr");
    support_expect(5, "No such file or directory", "render scenes/crater.glsl " TINY " -o /none/a.exr");
    support_expect(5, "/dev/full: cannot be written: No space left",
                   "render scenes/crater.glsl " TINY " -o /dev/full");
    assert_int_equal(symlink("/dev/full", support_path("full.png")), 0);
    support_expect(5, "No space left", "render scenes/crater.glsl " TINY " -o '%s'",
                   support_path("full.png"));
    support_expect(0, "", "render scenes/crater.glsl " TINY " --quiet -o /dev/null");

    /* A failing run leaves the old file alone; a good one replaces it and leaves nothing else behind. */
    assert_true(file_replace(old, "old", 3, &error));
    support_expect(2, "", "render scenes/crater.glsl --sky frob -o '%s'", old);
    struct stat status;
    assert_int_equal(stat(old, &status), 0);
    assert_int_equal(status.st_size, 3);
    support_expect(0, "", "render scenes/crater.glsl " TINY " --quiet -o '%s' -o '%s'", old,
                   support_path("new.png"));
    assert_int_equal(stat(old, &status), 0);
    assert_true(status.st_size > 100);
    char listing[1024];
    snprintf(listing, sizeof listing, "test -z \"$(ls -A '%s' | grep '^[.]magichour')\"", support_path(""));
    assert_int_equal(system(listing), 0);
}

/* Without any way to OpenGL, and with one way closed. */
static void test_no_gl(void **state) {
    (void)state;
    const char *out = support_path("out.exr");
    const char *closed =
        "DISPLAY= WAYLAND_DISPLAY= MAGICHOUR_OSMESA=/none.so __EGL_VENDOR_LIBRARY_FILENAMES=/none.json";
    int status = support_run(closed, "render scenes/crater.glsl -o '%s'", out);
    if (status != 4 || !strstr(support_err, "magichour: no OpenGL context: egl: ") ||
        !strstr(support_err, "osmesa: ") || !strstr(support_err, "glfw: ")) {
        fail_msg("%d: %s", status, support_err);
    }
    assert_int_equal(
        support_run("MAGICHOUR_OSMESA=/none.so", "render scenes/crater.glsl --backend osmesa -o '%s'", out),
        4);
    assert_false(exists(out));
    assert_int_equal(support_run(closed, "info"), 0);
    assert_non_null(strstr(support_out, "osmesa   refused: "));
    assert_non_null(strstr(support_out, "simmons2017-author"));
}

#define CLASH_TOP                                                                                            \
    "#include \"color/checker.glsl\"\n#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
#define CLASH_END                                                                                            \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit); }\n"  \
    "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n"

/* A name that the scene and the library both have: both places are named, whichever comes first. */
static void test_clashes(void **state) {
    (void)state;
    static const struct {
        const char *text, *own, *library;
    } rows[] = {
        {CLASH_TOP "const float PI = 3.0;\n" CLASH_END, "clash.glsl:4", "math/dialect.glsl:"},
        {"const float PI = 3.0;\n" CLASH_TOP CLASH_END, "clash.glsl:1", "math/dialect.glsl:"},
        {CLASH_TOP "vec3 checker(vec3 p, vec3 a, vec3 b) { return a; }\n" CLASH_END, "clash.glsl:4",
         "color/checker.glsl:"},
        {CLASH_TOP "struct Hit { float t; };\n" CLASH_END, "clash.glsl:4", "glsl/scene.glsl:"},
        {CLASH_TOP "\nfloat camera_eye = 1.0;\n" CLASH_END, "clash.glsl:5", "pass/camera.glsl:"},
        {CLASH_TOP "float hit_plane;\n" CLASH_END, "clash.glsl:4", "shape/plane.glsl:"},
        {"#define albedo 3.0\n" CLASH_TOP CLASH_END, "clash.glsl:1 has the name albedo",
         "material/matte.glsl:"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const char *path = support_write("clash.glsl", rows[i].text);
        support_expect(3, rows[i].own, "render '%s' " TINY " -o '%s'", path, support_path("out.exr"));
        if (!strstr(support_err, rows[i].library) ||
            !strstr(support_err, " too: give one of them another name"))
            fail_msg("%s: %s", rows[i].text, support_err);
    }
    const char *path = support_write("fault.glsl", CLASH_TOP "float f() { return y; }\n" CLASH_END);
    support_expect(3, "fault.glsl:4", "render '%s' " TINY " -o '%s'", path, support_path("out.exr"));
    assert_null(strstr(support_err, "another name"));
}

/* A scene's variable that is read before it is set: what the compiler says is passed on. */
static void test_unset(void **state) {
    (void)state;
    const char *path =
        support_write("unset.glsl", CLASH_TOP
                      "float f() {\n    float unset;\n    float set = 2.0 * unset;\n    return set;\n}\n"
                      "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                      "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                      "Material scene_material(Hit hit) { return matte(vec3(f())); }\n");
    support_expect(0, "", "info");
    bool mesa = strstr(support_out, "llvmpipe") != NULL;
    assert_int_equal(support_run("MESA_SHADER_CACHE_DISABLE=true", "render '%s' " TINY " -o '%s'", path,
                                 support_path("out.exr")),
                     0);
    if (mesa && (!strstr(support_err, "unset.glsl:6: ") || !strstr(support_err, "uninitialized")))
        fail_msg("%s", support_err);
}

static void test_progress(void **state) {
    (void)state;
    static const char *const keys[] = {"\"samples\": 32",       "\"paths\": 8192",   "\"seconds\": ",
                                       "\"startup_seconds\": ", "\"paths_per_s\": ", "\"rejected\": 0"};
    support_expect(0, "\"done\": true",
                   "render scenes/crater.glsl --size 16x16 --spp 32 --sky uniform --progress json -o '%s'",
                   support_path("out.exr"));
    const char *last = strstr(support_err, "{\"done\": true");
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) assert_non_null(strstr(last, keys[i]));
    assert_non_null(strstr(support_out, "Mpaths/s"));
    support_expect(0, "", "render scenes/crater.glsl " TINY " --quiet -o '%s'", support_path("out.exr"));
    assert_string_equal(support_out, "");
    assert_string_equal(support_err, "");
}

/* Ctrl-C saves the picture so far; so does the end of the time. It does not wait for a sky that takes long.
 */
static void test_interrupt(void **state) {
    (void)state;
    const char *program = getenv("MAGICHOUR");
    const char *out = support_path("interrupted.exr");
    char command[2048];
    /* It is interrupted when it has samples. */
    snprintf(
        command, sizeof command,
        "'%s' render scenes/crater.glsl --size 256x256 --spp 4000000000 --quiet --progress json -o '%s' "
        "2>'%s' & until grep -qs '\"samples\"' '%s'; do sleep 0.05; done; kill -INT $!; wait $!; exit $?",
        program ? program : "build/magichour", out, support_path("progress"), support_path("progress"));
    int status = system(command);
    assert_int_equal(WEXITSTATUS(status), 130);
    support_expect(0, "", "compare '%s' '%s'", out, out);
    assert_non_null(strstr(support_out, "65536, 0 not finite"));
    support_expect(0, "", "render scenes/crater.glsl --size 64x64 --time 0.3 --sky uniform -o '%s'", out);
    snprintf(
        command, sizeof command,
        "timeout --preserve-status -s INT 0.5 '%s' render scenes/crater.glsl --size 64x64 --spp 4000000000 "
        "--set atmosphere.orders=all --set atmosphere.spectrum=6 --quiet -o '%s'; exit $?",
        program ? program : "build/magichour", out);
    status = system(command);
    assert_int_equal(WEXITSTATUS(status), 130);
}

static void test_compare(void **state) {
    (void)state;
    const char *a = support_path("a.exr"), *b = support_path("b.pfm"), *c = support_path("c.pfm");
    support_expect(0, "", "render scenes/crater.glsl " TINY " --quiet -o '%s' -o '%s'", a, b);
    support_expect(0, "", "render scenes/crater.glsl " TINY " --seed 1 --quiet -o '%s'", c);
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 0 --max-bias 0", a, b);
    assert_non_null(strstr(support_out, "relRMSE      0.0000 %"));
    support_expect(6, "differs from", "compare '%s' '%s' --max-relrmse 0.001", a, c);
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 1000", a, c);
    support_expect(0, "", "render scenes/crater.glsl --size 8x8 --spp 1 --sky uniform --quiet -o '%s'", c);
    support_expect(2, "16x16", "compare '%s' '%s'", a, c);
}

/* A grey picture with a sun of 1e5 in some pixels, and metadata that name the sun's pixels. */
static void write_sun(const char *path, float grey, const char *pixels, const char *exposure) {
    Error error;
    AttributeList list = {0};
    Image image = image_create(20, 20);
    for (int i = 0; i < 4 * 400; i++) image.rgba[i] = i / 80 == 3 && i / 4 % 20 < 5 ? 1e5F * grey : grey;
    if (pixels) attribute_add(&list, "magichour.sun_pixels", "%s", pixels);
    if (exposure) attribute_add(&list, "magichour.exposure", "%s", exposure);
    assert_true(image_write(&image, path, &(ImageWriteParams){.attributes = &list}, &error));
    attribute_list_free(&list);
    image_free(&image);
}

/* The pixels of the sun's image in either file are left out; the levels have the reference's exposure. */
static void test_compare_shown(void **state) {
    (void)state;
    const char *a = support_path("shown.exr"), *b = support_path("shown2.exr"),
               *bad = support_path("bad.exr");
    write_sun(a, 0.11F, "0,3,3,1", NULL);
    write_sun(b, 0.1F, "2,3,3,1", "1");
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 10.001", a, b);
    assert_non_null(strstr(support_out, "sun pixels   5 left out"));
    assert_non_null(strstr(support_out, "pixels       395, 0 not finite"));
    double level = tone_level(TONE_AUTHOR, 2, (double)0.11F) - tone_level(TONE_AUTHOR, 2, (double)0.1F);
    char line[64];
    snprintf(line, sizeof line, "levels RMS   %.4f of 255", level);
    assert_non_null(strstr(support_out, line));
    support_expect(0, "", "compare '%s' '%s' --max-levels %g", a, b, level + 0.001);
    support_expect(6, "differs from", "compare '%s' '%s' --max-levels %g", a, b, level - 0.001);
    support_expect(6, "differs from", "compare '%s' '%s' --with-sun --max-relrmse 10.001", a, b);
    assert_non_null(strstr(support_out, "sun pixels   0 left out"));
    support_expect(0, "", "compare '%s' '%s' --exposure -2 --tone none", a, b);
    level = tone_level(TONE_NONE, 0.25, (double)0.11F) - tone_level(TONE_NONE, 0.25, (double)0.1F);
    snprintf(line, sizeof line, "levels RMS   %.4f of 255", level);
    assert_non_null(strstr(support_out, line));
    write_sun(bad, 0.1F, "0,3,50,1", NULL);
    support_expect(1, "bad.exr: sun pixels: '0,3,50,1' is not inside", "compare '%s' '%s'", a, bad);
    support_expect(0, "", "compare '%s' '%s' --with-sun", a, bad);
}

/* What users look into: a scene's parameters, and the shader that it makes. */
static void test_looking(void **state) {
    (void)state;
    support_expect(0, "", "info scenes/crater.glsl");
    assert_non_null(strstr(support_out, "--set ball=1"));
    assert_non_null(strstr(support_out, "--preset sunset: sun.elevation=5"));
    support_expect(0, "", "flatten scenes/crater.glsl --sky uniform");
    assert_null(strstr(support_out, "sky_paper"));
    assert_non_null(strstr(support_out, "#version 330 core"));
    support_expect(0, "", "--help");
    support_expect(0, "", "render --help");
    support_expect(0, "", "--version");
}

/* The README's scene in ten lines is one, and in ten. */
static void test_readme_scene(void **state) {
    (void)state;
    Text readme = {0}, scene = {0};
    Error error;
    assert_true(file_read("README.md", STATUS_FAILURE, &readme, &error));
    const char *line = strstr(text_string(&readme), "## Write a scene in ten lines\n\n");
    assert_non_null(line);
    line = strstr(line, "    //@");
    int lines = 0;
    for (; strncmp(line, "    ", 4) == 0; line = strchr(line, '\n') + 1, lines++) {
        text_print(&scene, "%.*s", (int)(strchr(line, '\n') + 1 - line) - 4, line + 4);
    }
    assert_int_equal(lines, 10);
    support_expect(0, "", "render '%s' " TINY " --set size=1 -o '%s'",
                   support_write("readme.glsl", text_string(&scene)), support_path("readme.png"));
    text_free(&readme);
    text_free(&scene);
}

/* A number of the last line of --progress json; -1 where it has none of that name. */
static double figure(const char *name) {
    double value = -1;
    char key[64];
    snprintf(key, sizeof key, "\"%s\": ", name);
    const char *done = strstr(support_err, "\"done\": true");
    const char *at = done ? strstr(done, key) : NULL;
    if (at) sscanf(at + strlen(key), "%lf", &value);
    return value;
}

/* Light that only chance finds is said to be that, and nothing is said where there is none: neither where all
 * mirrors are named nor where all is matte. */
static void test_by_chance(void **state) {
    (void)state;
    static const struct {
        /* What throws the light; NULL where none is left to chance. */
        const char *scene, *thrown;
    } cases[] = {{"mirrors", NULL},
                 {"materials", "thrown by glass and rough metal is"},
                 {"crater", NULL},
                 {"sundial", NULL},
                 {"knot", "thrown by rough metal is"},
                 {"author-room", "thrown by author is"},
                 {"author-ball", NULL},
                 {"pillars", NULL}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int disk = 0; disk < 2; disk++) {
            support_expect(0, "",
                           "render scenes/%s.glsl --atmosphere simmons2017 --size 32x32 --spp 16 --sun 30 %s "
                           "--progress json -o '%s'",
                           cases[i].scene, disk ? "--sun-disk=sampled" : "--sun-disk=off",
                           support_path("chance.exr"));
            bool warned = strstr(support_err, "found by chance") != NULL;
            bool expected = disk && cases[i].thrown;
            assert_true(warned == expected && warned == (strstr(support_err, "sun_by_chance") != NULL));
            if (!expected) continue;
            assert_non_null(strstr(support_err, cases[i].thrown));
            print_message("%s: %.2g %% of the light by chance\n", cases[i].scene,
                          figure("chance_light_percent"));
        }
    }
    support_expect(0, "--sun-disk=chance",
                   "render scenes/crater.glsl --size 16x16 --spp 1 --sun-disk=chance --progress json -o '%s'",
                   support_path("chance.exr"));
    assert_non_null(strstr(support_err, "\"sun_by_chance\": true"));
}

static double luminance(const float *rgb) {
    return 0.2126 * (double)rgb[0] + 0.7152 * (double)rgb[1] + 0.0722 * (double)rgb[2];
}

/* The share of the second picture's light that the first one lacks, without the specks that chance brought to
 * the first, and without the sun's own image. */
static double lacking(const char *without, const char *with) {
    Image images[2];
    Error error;
    double lacks = 0, all = 0;
    if (!image_read(&images[0], without, &error) || !image_read(&images[1], with, &error))
        fail_msg("%s", error.text);
    for (int i = 0; i < images[0].width * images[0].height; i++) {
        double part = luminance(images[0].rgba + 4 * i), whole = luminance(images[1].rgba + 4 * i);
        if (whole > 20) continue;
        lacks += whole > part ? whole - part : 0;
        all += whole;
    }
    for (int i = 0; i < 2; i++) image_free(&images[i]);
    return lacks / all;
}

/* A mirror ball and a great flat mirror, which throws sunlight on the ground. Where the flat one is not
 * named, its light is left to chance, and the share that `render` tells is the share that the picture lacks
 * against the one in which it is named. */
static void test_partly_named(void **state) {
    (void)state;
    static const char scene[] =
        "//@ camera eye 0 2 -5 target 0 0.8 0 fov 60\n//@ sun elevation 30 azimuth 90\n"
        "//@ mirror-sphere -1.5 0.5 0 0.5\n%s"
        "#include \"material/matte.glsl\"\n#include \"material/mirror.glsl\"\n"
        "#include \"shape/box.glsl\"\n#include \"shape/plane.glsl\"\n#include \"shape/sphere.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
        "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"
        "    hit_sphere(ray, vec3(-1.5, 0.5, 0.0), 0.5, 1, hit);\n"
        "    hit_box(ray, vec3(-2.5, 6.0, 0.0), vec3(0.02, 6.0, 8.0), 2, hit);\n}\n"
        "Material scene_material(Hit hit) {\n"
        "    if (hit.object == 1) return mirror(vec3(0.9));\n"
        "    if (hit.object == 2 && abs(hit.normal.x) > 0.5) return mirror(vec3(0.95));\n"
        "    return matte(vec3(0.5));\n}\n";
    const char *outs[2] = {support_path("partly.pfm"), support_path("all.pfm")};
    char text[2048];
    double chance[2];
    for (int named = 0; named < 2; named++) {
        snprintf(text, sizeof text, scene, named ? "//@ mirror-plane 90 0\n" : "");
        const char *path = support_write(named ? "all.glsl" : "partly.glsl", text);
        support_expect(0, "", "render '%s' --size 32x32 --spp 128 --sun-disk --progress json -o '%s'", path,
                       outs[named]);
        bool warned = strstr(support_err, "found by chance") != NULL;
        assert_true(named || (warned && strstr(support_err, "mirrors that the scene does not name")));
        chance[named] = figure("chance_light_percent");
        assert_true(figure("chance_paths_percent") > 0 && figure("chance_pixels_percent") > 0);
    }
    double truth = 100 * lacking(outs[0], outs[1]);
    print_message(
        "one of two mirrors named: %.3g %% of the light by chance, in truth %.3g %%; both named: %.3g %%\n",
        chance[0], truth, chance[1]);
    assert_true(truth > 20 && chance[0] > 0.7 * truth && chance[0] < 1.4 * truth);
    assert_true(chance[1] < 0.15 * truth);
}

/* A material that the library does not know, which has one direction as a mirror has and does not tell what
 * it throws: it is told by its name. */
static void test_own_material_by_chance(void **state) {
    (void)state;
    const char *folder = support_path("material");
    assert_true(mkdir(folder, 0777) == 0);
    const char *pearl = support_write(
        "material/pearl_shell.glsl",
        "#include \"scene.glsl\"\n"
        "Material pearl_shell() { return material_new(MATERIAL_PEARL_SHELL, vec3(0.8)); }\n"
        "Bounce pearl_shell_sample(Material m, vec3 normal, vec3 incoming, vec2 u, vec2 v) {\n"
        "    return Bounce(reflect(incoming, normal), m.color, 0.0, false);\n}\n"
        "float pearl_shell_pdf(Material m, vec3 normal, vec3 incoming, vec3 outgoing) { return 0.0; }\n"
        "vec3 pearl_shell_value(Material m, vec3 normal, vec3 incoming, vec3 outgoing) { return vec3(0.0); "
        "}\n");
    const char *path =
        support_write("pearl.glsl", "//@ camera eye 0 2 -4 target 0 0.5 0\n#include \"material/matte.glsl\"\n"
                                    "#include \"material/pearl_shell.glsl\"\n#include \"shape/plane.glsl\"\n"
                                    "#include \"shape/sphere.glsl\"\n"
                                    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                                    "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"
                                    "    hit_sphere(ray, vec3(0.0, 1.0, 0.0), 1.0, 1, hit);\n}\n"
                                    "Material scene_material(Hit hit) {\n"
                                    "    if (hit.object == 1) return pearl_shell();\n"
                                    "    return matte(vec3(0.5));\n}\n");
    support_expect(0, "thrown by pearl shell is found by chance",
                   "render '%s' --size 32x32 --spp 16 --sun 40 --sun-disk -o '%s'", path,
                   support_path("pearl.pfm"));
    unlink(pearl);
    rmdir(folder);
}

/* A mirror is all that the picture sees, and in it the surroundings of the sun. So each path is left to
 * chance, in each pixel; and each would meet the cone of 20 degrees over which the sun is spread. The mirror
 * sees a sky of luminance 1, and beside it the sun's irradiance over the cone's solid angle: that of a cone
 * that the horizon cuts is left as it is far from the horizon. The irradiance is what a white floor shows. */
static void test_chance_by_hand(void **state) {
    (void)state;
    static const char scene[] =
        "//@ camera eye 0 1 0 target 0 0 0.8391 fov 10\n//@ sun elevation 50 azimuth 0\n%s"
        "#include \"material/matte.glsl\"\n#include \"material/mirror.glsl\"\n#include \"shape/plane.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
        "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
        "Material scene_material(Hit hit) { return %s; }\n";
    const double degree = acos(-1) / 180, solid_angle = 2 * acos(-1) * (1 - cos(20 * degree));
    const char *out = support_path("hand.pfm");
    char text[1024];
    Image image;
    Error error;
    snprintf(text, sizeof text, scene, "", "matte(vec3(1.0))");
    support_expect(0, "",
                   "render '%s' --size 16x16 --spp 16 --sky uniform:0 --sun-disk --progress json -o '%s'",
                   support_write("white.glsl", text), out);
    assert_true(figure("chance_paths_percent") < 0); /* nothing is counted */
    if (!image_read(&image, out, &error)) fail_msg("%s", error.text);
    double irradiance = luminance(image.rgba) * acos(-1) / sin(50 * degree);
    image_free(&image);
    snprintf(text, sizeof text, scene, "", "mirror(vec3(0.9))");
    support_expect(0, "found by chance",
                   "render '%s' --size 16x16 --spp 16 --sky uniform:1 --sun-disk --progress json -o '%s'",
                   support_write("mirror.glsl", text), out);
    double light = figure("chance_light_percent"), expected = irradiance / solid_angle;
    print_message("in a mirror: light by chance is %.4g of the other light, reckoned %.4g\n",
                  light / (100 - light), expected);
    assert_true(figure("chance_paths_percent") == 100 && figure("chance_pixels_percent") == 100);
    assert_true(fabs(light / (100 - light) / expected - 1) < 0.01);
    /* A flat mirror that is named shows the sun as large as it is, and leaves nothing to chance. */
    snprintf(text, sizeof text, scene, "//@ mirror-plane 0 90\n", "mirror(vec3(0.9))");
    support_expect(0, "",
                   "render '%s' --size 16x16 --spp 16 --sky uniform:1 --sun-disk --progress json -o '%s'",
                   support_write("named.glsl", text), out);
    assert_null(strstr(support_err, "chance"));
}

/* What auto takes, and that it says why: by the error asked for and by the paths that repay a table. */
static void test_auto(void **state) {
    (void)state;
    const char *out = support_path("auto.exr");
    support_expect(0, "auto took sky table:gauss:6@32x96: bias 0.",
                   "render scenes/crater.glsl --size 256x256 --time 0.01 -v -o '%s'", out);
    assert_non_null(strstr(support_err, "auto took light control: "));
    support_expect(0, "auto took sky gauss:4: bias 3.",
                   "render scenes/crater.glsl --size 64x64 --error 10 -v -o '%s'", out);
    assert_non_null(strstr(support_err, "auto took light cosine: "));
    assert_int_equal(
        support_run("", "render scenes/crater.glsl --size 256x256 --error 0.1 --time 0.01 -v -o '%s'", out),
        STATUS_UNPROMISED);
    assert_non_null(strstr(support_err, "auto took sky table:gauss:8@64x192: bias 0.0"));
    support_expect(
        0, "sky table:gauss:5@9x30, sun disk off, light mis,",
        "render scenes/crater.glsl --size 8x8 --spp 1 --sky table:gauss:5@9x30 --light mis -v -o '%s'", out);
    assert_null(strstr(support_err, "auto took"));
    support_expect(0, "sun disk sampled, light cosine,",
                   "render scenes/crater.glsl --size 64x64 --spp 1 --sun-disk -v -o '%s'", out);
    support_expect(0, "sun disk off,",
                   "render scenes/crater.glsl --size 8x8 --spp 1 --sun -1 --sun-disk -v -o '%s'", out);
    support_expect(0, "sun disk chance,",
                   "render scenes/crater.glsl --size 8x8 --spp 1 --sun-disk=chance -v -o '%s'", out);
    support_expect(0, "sky uniform:1,", "render scenes/furnace.glsl --size 8x8 --spp 1 -v -o '%s'", out);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_usage),
        cmocka_unit_test(test_loop_budget),
        cmocka_unit_test(test_loop_limit_holds),
        cmocka_unit_test(test_scene_errors),
        cmocka_unit_test(test_included_error),
        cmocka_unit_test(test_outputs),
        cmocka_unit_test(test_no_gl),
        cmocka_unit_test(test_progress),
        cmocka_unit_test(test_clashes),
        cmocka_unit_test(test_unset),
        cmocka_unit_test(test_interrupt),
        cmocka_unit_test(test_auto),
        cmocka_unit_test(test_by_chance),
        cmocka_unit_test(test_partly_named),
        cmocka_unit_test(test_chance_by_hand),
        cmocka_unit_test(test_own_material_by_chance),
        cmocka_unit_test(test_readme_scene),
        cmocka_unit_test(test_compare),
        cmocka_unit_test(test_compare_shown),
        cmocka_unit_test(test_looking),
    };
    return cmocka_run_group_tests_name("cli", tests, support_folder, support_clean);
}
