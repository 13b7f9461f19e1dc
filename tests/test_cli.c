/* The program as a user meets it: exit statuses, errors with their place, files whole or untouched. */
#include "support.h"

#include "base/file.h"
#include "gl/loops.h"
#include "image/format.h"

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
    support_expect(2, "unknown method 'frob' (known: auto, additive, random, metropolis, sobol)",
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
        "'%s' render scenes/crater.glsl --size 256x256 --spp 16000000 --quiet --progress json -o '%s' "
        "2>'%s' & until grep -qs '\"samples\"' '%s'; do sleep 0.05; done; kill -INT $!; wait $!; exit $?",
        program ? program : "build/magichour", out, support_path("progress"), support_path("progress"));
    int status = system(command);
    assert_int_equal(WEXITSTATUS(status), 130);
    support_expect(0, "", "compare '%s' '%s'", out, out);
    assert_non_null(strstr(support_out, "65536, 0 not finite"));
    support_expect(0, "", "render scenes/crater.glsl --size 64x64 --time 0.3 --sky uniform -o '%s'", out);
    snprintf(
        command, sizeof command,
        "timeout --preserve-status -s INT 0.5 '%s' render scenes/crater.glsl --size 64x64 --spp 16000000 "
        "--set atmosphere.orders=all --set atmosphere.spectrum=6 --quiet -o '%s'; exit $?",
        program ? program : "build/magichour", out);
    status = system(command);
    assert_int_equal(WEXITSTATUS(status), 130);
}

/* A shader that takes a driver minutes: each function calls the one before it twice. */
static const char *endless_shader(void) {
    char text[4096];
    size_t used = (size_t)snprintf(text, sizeof text,
                                   "#include \"material/matte.glsl\"\n"
                                   "#include \"shape/sphere.glsl\"\n"
                                   "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                                   "    hit_sphere(ray, vec3(0.0), 1.0, 0, hit);\n}\n"
                                   "float f0(float x) { return sin(x); }\n");
    for (int i = 1; i <= 18; i++)
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "float f%d(float x) { return f%d(x) + f%d(x * 1.1); }\n", i, i - 1, i - 1);
    snprintf(text + used, sizeof text - used,
             "Material scene_material(Hit hit) { return matte(vec3(f18(hit.t))); }\n");
    return support_write("endless.glsl", text);
}

/* Compiling ends after the time that it may take, and at once when it is interrupted. */
static void test_compiling(void **state) {
    (void)state;
    const char *scene = endless_shader(), *program = getenv("MAGICHOUR"), *out = support_path("endless.pfm");
    char command[2048];
    support_expect(STATUS_SCENE, "the driver has compiled a shader for 0.5 s of processor time",
                   "render '%s' --size 8x8 --spp 1 --compile-time 0.5 -o '%s'", scene, out);
    snprintf(command, sizeof command,
             "timeout --preserve-status -s TERM -k 20 1 '%s' render '%s' --size 8x8 --spp 1 --quiet -o '%s'; "
             "exit $?",
             program ? program : "build/magichour", scene, out);
    assert_int_equal(WEXITSTATUS(system(command)), STATUS_INTERRUPTED);
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
        cmocka_unit_test(test_outputs),
        cmocka_unit_test(test_no_gl),
        cmocka_unit_test(test_progress),
        cmocka_unit_test(test_interrupt),
        cmocka_unit_test(test_auto),
        cmocka_unit_test(test_readme_scene),
        cmocka_unit_test(test_looking),
        cmocka_unit_test(test_compiling),
    };
    return cmocka_run_group_tests_name("cli", tests, support_folder, support_clean);
}
