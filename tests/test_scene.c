/* Scene files: annotations, settings, the atmosphere's numbers, and GLSL text from many files. */
#include "support.h"

#include "base/number.h"
#include "base/text.h"
#include "scene/scene.h"
#include "source/glsl_log.h"
#include "source/glsl_scan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void test_annotations(void **state) {
    (void)state;
    Scene scene;
    Error error;
    const char *path = support_write(
        "good.glsl", "//@ title A  scene\r\n"
                     "//@ camera eye 1 2 3 target 4 5 6 fov 40\n"
                     "//@ sun azimuth 90 elevation -2\n"
                     "//@ size 320 200\n"
                     "//@ exposure 2\n"
                     "//@ sky uniform:3\n"
                     "//@ atmosphere simmons2017-author\n"
                     "//@ preset low sun.elevation 1 height 2.5 tint 1,0,0.5 atmosphere.mie_g 0.5\n"
                     "uniform float height; //@ slider 1 min -1 max 3 unit m label \"how high\"\n"
                     "uniform bool lamp; //@ checkbox off\n"
                     "uniform vec3 tint; //@ color 0.1 0.2 0.3 label paint\n"
                     "float f() { return 1.0; } // not one: //@ frob\n");
    if (!scene_read(&scene, path, "glsl", &error)) fail_msg("%s", error.text);
    assert_string_equal(scene.file->title, "A scene");
    assert_true(scene.values.camera.eye[2] == 3 && scene.values.camera.target[0] == 4 &&
                scene.values.camera.fov_deg == 40);
    assert_true(scene.values.sun.elevation_deg == -2 && scene.values.sun.azimuth_deg == 90);
    assert_int_equal(scene.file->width, 320);
    assert_int_equal(scene.file->height, 200);
    assert_true(scene.values.exposure_ev == 2);
    assert_string_equal(scene.file->sky, "uniform:3");
    assert_true(scene.values.atmosphere.rayleigh_scatter_per_m[0] == 3.8e-6);
    assert_int_equal(scene.file->parameter_count, 3);
    assert_string_equal(scene.file->parameters[0].label, "how high");
    assert_string_equal(scene.file->parameters[0].unit, "m");
    assert_true(scene.values.parameters[1][0] == 0);
    assert_true(scene.values.parameters[2][2] == 0.3);
    assert_true(scene_choose_preset(&scene, "low", &error));
    assert_true(scene.values.sun.elevation_deg == 1 && scene.values.parameters[0][0] == 2.5);
    assert_true(scene.values.parameters[2][0] == 1 && scene.values.atmosphere.mie_g == 0.5);
    assert_true(scene_set(&scene, "lamp", "on", &error) && scene.values.parameters[1][0] == 1);
    assert_false(scene_set(&scene, "lamp", "2", &error));
    assert_false(scene_set(&scene, "height", "3.5", &error));
    assert_non_null(strstr(error.text, "height: 3.5 is outside the range from -1 to 3"));
    assert_false(scene_set(&scene, "hight", "3", &error));
    assert_non_null(strstr(
        error.text, "no setting 'hight': did you mean height? (known: height, lamp, tint, sun.elevation"));
    assert_false(scene_set(&scene, "atmosphere.mie", "nan", &error));
    assert_non_null(strstr(error.text, "atmosphere.mie: 'nan' is not a number, and one from 0"));
    assert_false(scene_choose_preset(&scene, "high", &error));
    assert_non_null(strstr(error.text, "no preset 'high' (known: low)"));
    assert_true(scene_check(&scene, &error));
    assert_true(scene_set(&scene, "camera.eye", "4,5,6", &error));
    assert_false(scene_check(&scene, &error));
    scene_destroy(&scene);
}

static void test_annotations_refused(void **state) {
    (void)state;
    static const struct {
        const char *line, *part;
    } cases[] = {
        {"//@ frob 1", "unknown annotation 'frob' (known: title, look"},
        {"//@", "an annotation needs a key"},
        {"//@ camera eye 0 0", "eye needs 3 numbers"},
        {"//@ camera eye 0 0 x", "eye: 'x' is not a number"},
        {"//@ camera eye 0 nan 0", "eye: 'nan' is not a number"},
        {"//@ camera fov 180", "fov: 180 is outside the range from 0.01 to 179"},
        {"//@ camera zoom 3", "camera: unknown key 'zoom'"},
        {"//@ sun elevation 95", "95 is outside the range from -90 to 90"},
        {"//@ size 0 0", "picture size 0x0"},
        {"//@ size 100000 100000", "each side must be from 1 to 16384"},
        {"//@ size 10.5 3", "two whole numbers"},
        {"//@ size 512", "size needs 2 numbers"},
        {"//@ title \"open", "quotation mark is not closed"},
        {"//@ atmosphere mars", "unknown atmosphere 'mars' (known: simmons2017"},
        {"//@ preset a sun.elevation", "pairs of setting and value"},
        {"//@ preset a sun.elevation 95", "95 is outside the range from -90 to 90"},
        {"//@ preset a frob 1", "no setting 'frob'"},
        {"//@ bound 1 2 3", "bound needs x y z radius"},
        {"//@ mirror-sphere 1 2", "mirror-sphere needs x y z radius"},
        {"//@ mirror-plane 1", "mirror-plane needs the azimuth and the elevation"},
        {"//@ mirror-plane 0 frob", "mirror-plane: 'frob' is neither a number nor a slider's name"},
        {"//@ mirror-sphere 0 0 0 frob", "mirror-sphere: 'frob' is neither a number above 0"},
        {"//@ spheres", "spheres needs a number, a slider's name or a .csv file"},
        {"//@ spheres 1 2", "spheres needs a number, a slider's name or a .csv file"},
        {"//@ spheres 1.5", "spheres: '1.5' is not a whole number"},
        {"//@ spheres 1000001", "spheres: 1000001 is outside the range from 0 to 1000000"},
        {"//@ spheres -1", "spheres: -1 is outside the range"},
        {"//@ spheres frob", "spheres: 'frob' is neither a number, a slider's name nor a .csv file"},
        {"//@ spheres .csv", "spheres: '.csv' is neither a number"},
        {"//@ emitter-sphere 1 2 3", "emitter-sphere needs x y z radius"},
        {"//@ emitter-sphere 0 frob 0 1", "emitter-sphere: 'frob' is neither a number nor a slider's name"},
        {"//@ emitter-sphere 0 0 0 -1", "emitter-sphere: '-1' is neither a number above 0"},
        {"//@ sun-disk maybe", "sun-disk needs on or off"},
        {"//@ sun radius 40", "radius: 40 is outside the range from 0.01 to 30"},
        {"//@ preset a_name_of_more_than_sixty_three_characters_which_is_too_long_to_be_kept",
         "more than 63 characters"},
        {"//@ bound 1 2 frob 1", "bound: 'frob' is neither a number nor a slider's name"},
        {"//@ bound 1 2 3 0", "bound: '0' is neither a number above 0 nor a slider's name"},
        {"//@ slider 1", "slider stands behind `uniform float NAME;`"},
        {"uniform vec3 a; //@ slider 1", "'a' is a vec3"},
        {"uniform float a; //@ slider", "slider needs 1 number"},
        {"uniform float a; //@ slider 2", "2 is outside the range from 0 to 1"},
        {"uniform float a; //@ slider 1 mix 3", "unknown key 'mix'"},
        {"uniform bool a; //@ checkbox maybe", "checkbox needs on or off"},
        {"uniform vec3 a; //@ color 0 0", "color needs 3 numbers"},
        {"uniform vec3 a; //@ color 0 0 2", "color: 2 is outside the range from 0 to 1"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Scene scene;
        Error error = {0};
        char text[256], place[64];
        snprintf(text, sizeof text, "// one\n\n%s\n", cases[i].line);
        const char *path = support_write("bad.glsl", text);
        assert_false(scene_read(&scene, path, "glsl", &error));
        assert_int_equal(error.status, STATUS_SCENE);
        snprintf(place, sizeof place, "bad.glsl:3: ");
        if (!strstr(error.text, place) || !strstr(error.text, cases[i].part)) {
            fail_msg("%s: %s", cases[i].line, error.text);
        }
    }
    Scene scene;
    Error error;
    const char *twice =
        support_write("bad.glsl", "uniform float a; //@ slider 1\nuniform float a; //@ slider 1\n");
    assert_false(scene_read(&scene, twice, "glsl", &error));
    assert_non_null(strstr(error.text, "bad.glsl:2: uniform 'a' is declared twice"));
    const char *again = support_write("bad.glsl", "//@ spheres 1\n//@ spheres 2\n");
    assert_false(scene_read(&scene, again, "glsl", &error));
    assert_non_null(strstr(error.text, "bad.glsl:2: spheres is there already"));
    const char *range =
        support_write("bad.glsl", "//@ spheres a\nuniform float a; //@ slider 1 min -1 max 5\n");
    assert_false(scene_read(&scene, range, "glsl", &error));
    assert_non_null(
        strstr(error.text, "bad.glsl:1: spheres: the slider 'a' goes from -1 to 5, past 0 to 1000000"));
}

static void test_atmosphere(void **state) {
    (void)state;
    static const double paper[3] = {5.47e-6, 12.79e-6, 31.2e-6};
    static const char *const lambda[3] = {"680", "550", "440"};
    Atmosphere a;
    Error error;
    assert_true(atmosphere_choose(&a, "simmons2017", &error));
    for (int c = 0; c < 3; c++) {
        double number = 0;
        assert_true(number_parse(lambda[c], &number));
        double formula = atmosphere_rayleigh_formula(1.0003, 2.545e25, number * 1e-9);
        assert_true(fabs(formula / paper[c] - 1) < 2e-3);
        assert_true(fabs(formula / a.rayleigh_scatter_per_m[c] - 1) < 0.07);
    }
    /* A wavelength brings the formula in: blue light scatters by the fourth power. */
    assert_true(atmosphere_set(&a, "wavelengths_nm", "800,400,400", &error));
    assert_true(fabs(a.rayleigh_scatter_per_m[1] / a.rayleigh_scatter_per_m[0] - 16) < 1e-9);
    assert_true(atmosphere_set(&a, "rayleigh_scatter_per_m", "1e-6,2e-6,3e-6", &error));
    assert_true(a.rayleigh_scatter_per_m[2] == 3e-6);
    assert_false(atmosphere_set(&a, "rayleigh_scatter_per_m", "1e-6,2e-6", &error));
    assert_false(atmosphere_set(&a, "mie_g", "1", &error));
    assert_non_null(strstr(error.text, "atmosphere.mie_g: 1 is outside the range from -0.999 to 0.999"));
    assert_true(atmosphere_set(&a, "top_radius_m", "6360000", &error));
    assert_false(atmosphere_check(&a, &error));
    assert_non_null(strstr(error.text, "must be above"));
}

static void test_flatten(void **state) {
    (void)state;
    GlslSource source;
    Error error;
    support_write("b.glsl", "float b() { return 1.0; }");
    support_write("c.glsl", "#include \"b.glsl\"\nfloat c() { return b(); }\n");
    const char *path =
        support_write("a.glsl", "#version 330 core\n/* #include \"none.glsl\" */\n"
                                "#include \"c.glsl\"\n  #  include \"b.glsl\"\n#include <slot>\nlast\n");
    const GlslSlot slots[] = {{"slot", support_path("b.glsl"), NULL}, {NULL, NULL, NULL}};
    if (!support_flatten(&source, "glsl", path, slots, &error)) fail_msg("%s", error.text);
    assert_string_equal(
        text_string(&source.text),
        "#version 330 core\n#line 2 0\n/* #include \"none.glsl\" */\n"
        "#line 1 1\n#line 1 2\nfloat b() { return 1.0; }\n#line 2 1\nfloat c() { return b(); }\n"
        "#line 4 0\n#line 5 0\n#line 6 0\nlast\n");
    assert_int_equal(source.file_count, 3);

    /* The forms in which drivers report. */
    glsl_source_explain(&source, "0:6(7): error: first\n0:8(3): warning: no\n0:12(1): error: second\n",
                        &error);
    char expected[1024];
    snprintf(expected, sizeof expected, "%s:1: first\n%s:6: second", support_path("b.glsl"), path);
    assert_string_equal(error.text, expected);
    assert_int_equal(error.status, STATUS_SCENE);
    glsl_source_explain(&source, "0(8) : error C1008: undefined variable \"x\"\n", &error);
    assert_non_null(strstr(error.text, "c.glsl:2: error C1008"));
    glsl_source_explain(&source, "ERROR: 0:8: 'x' : undeclared identifier\n", &error);
    assert_non_null(strstr(error.text, "c.glsl:2: 'x' : undeclared"));
    glsl_source_explain(&source, "link failed for reasons", &error);
    assert_non_null(strstr(error.text, "link failed for reasons"));
    glsl_source_explain(&source, "0:0(0): error: function `f' has static recursion\n", &error);
    assert_non_null(strstr(error.text, ": function `f' has static recursion"));
    char *plain = glsl_source_plain(&source);
    assert_null(strstr(plain, "#line"));
    assert_int_equal(strlen(plain), source.text.size);
    free(plain);
    glsl_source_destroy(&source);
}

static void test_flatten_refused(void **state) {
    (void)state;
    static const struct {
        const char *line, *part;
    } cases[] = {
        {"#include \"none.glsl\"", "no file 'none.glsl' beside this one or in glsl"},
        {"#include none.glsl", "#include needs \"file.glsl\" or <slot>"},
        {"#include", "#include needs"},
        {"#include <frob>", "unknown slot <frob>"},
        {"/* open", "a comment is not closed"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        GlslSource source;
        Error error;
        char text[128];
        snprintf(text, sizeof text, "\n%s\n", cases[i].line);
        assert_false(support_flatten(&source, "glsl", support_write("bad.glsl", text), NULL, &error));
        if (!strstr(error.text, "bad.glsl:2: ") || !strstr(error.text, cases[i].part)) {
            fail_msg("%s: %s", cases[i].line, error.text);
        }
    }
}

static void test_defines(void **state) {
    (void)state;
    static const struct {
        const char *text;
        bool defines;
    } cases[] = {
        {"void hit(INOUT(Hit) a, int b)\n{ }", true},
        {"void hit(int a);", false},
        {"// void hit() {}\n", false},
        {"/* void hit() {} */", false},
        {"void hit_all() {}", false},
        {"void rehit() {}", false},
        {"void f() { hit(1); }\nvoid hit(int a) {}", true},
        {"void f() { hit(1); }", false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        GlslSource source;
        Error error;
        assert_true(support_flatten(&source, "glsl", support_write("d.glsl", cases[i].text), NULL, &error));
        GlslScan scan = glsl_scan(text_string(&source.text));
        if (glsl_scan_defines(&scan, "hit") != cases[i].defines) fail_msg("%s", cases[i].text);
        glsl_scan_free(&scan);
        glsl_source_destroy(&source);
    }
}

/* A scene in the working folder that is called as one of the library's files is still the scene. */
static void test_own_file(void **state) {
    (void)state;
    const GlslSlot slots[] = {{"scene", "LICENSE", NULL}, {NULL, NULL, NULL}};
    const char *entry = support_write("own.glsl", "#include <scene>\n");
    GlslSource source;
    Error error;
    support_write("LICENSE", "masked");
    char *library = strdup(support_path("."));
    assert_true(support_flatten(&source, library, entry, slots, &error));
    assert_null(strstr(text_string(&source.text), "masked"));
    glsl_source_destroy(&source);
    assert_true(support_flatten(&source, library, "LICENSE", NULL, &error));
    assert_null(strstr(text_string(&source.text), "masked"));
    glsl_source_destroy(&source);
    free(library);
}

/* A scene compiles what it includes and nothing else, and a new material needs no edit elsewhere. */
static void test_materials(void **state) {
    (void)state;
    GlslSource source;
    Error error;
    const GlslSlot slots[] = {{"scene", "scenes/furnace.glsl", NULL}, {NULL, NULL, NULL}};
    const char *entry = support_write("entry.glsl", "#include <scene>\n#include <materials>\n");
    assert_true(support_flatten(&source, "glsl", entry, slots, &error));
    const char *text = text_string(&source.text);
    assert_non_null(strstr(text, "const int MATERIAL_MATTE = 0;"));
    assert_non_null(strstr(text, "const int MATERIAL_MIRROR = 1;"));
    assert_non_null(strstr(text, "if (material.kind == 0)\n        return matte_sample("));
    assert_null(strstr(text, "checker"));
    glsl_source_destroy(&source);
}

static void expect_sun(const Sun *sun) {
    double degree = acos(-1) / 180, elevation = sun->elevation_deg * degree,
           azimuth = sun->azimuth_deg * degree;
    assert_true(fabs(sun->direction[0] - cos(elevation) * sin(azimuth)) < 1e-12);
    assert_true(fabs(sun->direction[1] - sin(elevation)) < 1e-12);
    assert_true(fabs(sun->direction[2] - cos(elevation) * cos(azimuth)) < 1e-12);
    assert_true(fabs(sun->level[0] - sin(azimuth)) < 1e-12 && fabs(sun->level[2] - cos(azimuth)) < 1e-12);
    assert_true(fabs(sun->level[1]) < 1e-12);
}

/* The sun's vectors follow whatever moves it, and two scenes are the same by their file and their values. */
static void test_values(void **state) {
    (void)state;
    Scene scene, again;
    Error error;
    const char *path =
        support_write("sun.glsl", "//@ sun azimuth 70 elevation 12\n//@ preset low sun.elevation 1\n"
                                  "uniform float a; //@ slider 0.5\n");
    assert_true(scene_read(&scene, path, "glsl", &error) && scene_read(&again, path, "glsl", &error));
    assert_true(scene.values.sun.elevation_deg == 12);
    expect_sun(&scene.values.sun);
    assert_true(scene_set(&scene, "sun.azimuth", "-110", &error));
    expect_sun(&scene.values.sun);
    assert_true(scene_choose_preset(&scene, "low", &error) && scene.values.sun.elevation_deg == 1);
    expect_sun(&scene.values.sun);
    scene_set_sun(&scene, 90, 45);
    expect_sun(&scene.values.sun);
    Scene shared = scene_share(&scene);
    scene_destroy(&scene);
    assert_string_equal(shared.file->path, path);
    Scene copy = shared;
    assert_true(scene_same(&copy, &shared));
    assert_true(scene_set(&copy, "a", "0.25", &error) && !scene_same(&copy, &shared));
    assert_true(scene_set(&copy, "a", "0.5", &error) && scene_same(&copy, &shared));
    copy.values.sun_disk = true;
    assert_false(scene_same(&copy, &shared));
    Scene other = {again.file, shared.values};
    assert_false(scene_same(&other, &shared));
    scene_destroy(&shared);
    scene_destroy(&again);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_annotations),     cmocka_unit_test(test_annotations_refused),
        cmocka_unit_test(test_atmosphere),      cmocka_unit_test(test_flatten),
        cmocka_unit_test(test_flatten_refused), cmocka_unit_test(test_defines),
        cmocka_unit_test(test_materials),       cmocka_unit_test(test_own_file),
        cmocka_unit_test(test_values),
    };
    return cmocka_run_group_tests_name("scene", tests, support_folder, support_clean);
}
