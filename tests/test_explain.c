/* `magichour explain`, and what it says of the shader: no code of a term that is off, nor of a shape that the
 * scene does not use. */
#include "support.h"

#include "chart/worth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The row of a term, up to its line's end. */
static const char *row_of(const char *term) {
    static char row[256];
    const char *at = strstr(support_out, term);
    if (!at) fail_msg("no '%s' in: %s", term, support_out);
    snprintf(row, sizeof row, "%.*s", (int)strcspn(at, "\n"), at);
    return row;
}

static void expect_row(const char *term, const char *verdict) {
    const char *row = row_of(term);
    if (!strstr(row, verdict)) fail_msg("not '%s': %s", verdict, row);
}

static void test_crater(void **state) {
    (void)state;
    support_expect(0, "", "explain scenes/crater.glsl --size 24x24");
    assert_non_null(strstr(support_out, "Crater, 24x24, sun at 30, at an error of 1 %: sky "));
    expect_row("Rayleigh scattering", "   needed");
    expect_row("Mie scattering", "   needed");
    expect_row("ozone", "off here");
    expect_row("further orders of scattering", "off here");
    expect_row("light from the ground", "off here");
    expect_row("colours from a spectrum", "off here");
    expect_row("harmonics beyond degree 8", "        -        -        -   off here");
    expect_row("the sun's disk", "off here");
    expect_row("sunlight off mirror spheres", "        -        -        -   off here");
    expect_row("hits beyond the first", "   needed");
    expect_row("hits beyond the eighth", "not needed");
    expect_row("more than 8 nodes", "off here");
    expect_row("ball (the scene's)", "   needed");
    expect_row("low-discrepancy sequence", "   needed");
    assert_null(strstr(support_out, "compiled"));
}

/* The library's files are listed where that is asked for. */
static void test_files(void **state) {
    (void)state;
    support_expect(0, "", "explain scenes/crater.glsl --size 8x8 -vv");
    expect_row("material: ", "matte mirror, not author");
    expect_row("  shape: ", "plane_minus_sphere sphere, not box");
    expect_row("  sun: ", "ask off share share_whole, not aim");
    const char *out = support_path("a.exr");
    support_expect(0, "sky gauss:", "render scenes/crater.glsl --size 8x8 --spp 1 -v -o '%s'", out);
    assert_null(strstr(support_err, "compiled: "));
    support_expect(0, "sky gauss:", "render scenes/crater.glsl --size 8x8 --spp 1 -vv -o '%s'", out);
    assert_non_null(strstr(support_err, "compiled: "));
    assert_non_null(strstr(support_err, "plane_minus_sphere.glsl"));
}

static void test_furnace(void **state) {
    (void)state;
    support_expect(0, "", "explain scenes/furnace.glsl --size 16x16 --depth 2 --error 60");
    expect_row("Rayleigh scattering", "        -        -        -   off here");
    expect_row("more than 4 nodes", "        -        -        -   off here");
    expect_row("further orders of scattering", "        -        -        -   off here");
    expect_row("light from the ground", "        -        -        -   off here");
    expect_row("colours from a spectrum", "        -        -        -   off here");
    expect_row("hits beyond the first", "not needed"); /* to 60 % */
    expect_row("hits beyond the second", "off here");
    expect_row("control variate", "        -        -        -   off here");
    support_expect(3, "none.glsl: cannot be read", "explain none.glsl");
    support_expect(2, "--error: 0 is outside the range from", "explain scenes/crater.glsl --error 0");
}

static const Term *find_term(const Term *terms, int count, const char *name) {
    for (int i = 0; i < count; i++) {
        if (strcmp(terms[i].name, name) == 0) return &terms[i];
    }
    fail_msg("no term %s", name);
    return NULL;
}

/* Changes that are known: ground of albedo 0.5 or 0.4 under a sky of 1 fills the picture, and nothing is hit
 * after it. */
static void test_change(void **state) {
    (void)state;
    Context context;
    Scene scene;
    Error error;
    WorthBase base;
    Worth worth;
    int count;
    const char *path = support_write(
        "ground.glsl", "//@ camera eye 0 2 0 target 0 0 0.1 fov 40\n//@ sky uniform:1\n"
                       "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
                       "uniform bool pale; //@ checkbox on\n"
                       "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                       "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                       "Material scene_material(Hit hit) { return matte(vec3(pale ? 0.5 : 0.4)); }\n");
    support_open(&context);
    assert_true(scene_read(&scene, path, "glsl", &error));
    RenderParams params = {.scene = &scene, .width = 16, .height = 16};
    Term *terms = term_list(&params, &count);
    if (!worth_begin(&base, &context, &params, 16, NULL, &error)) fail_msg("%s", error.text);
    assert_true(worth_of(&base, find_term(terms, count, "pale (the scene's)"), NULL, &worth, &error));
    assert_int_equal(worth.state, TERM_ON);
    if (fabs(worth.change_percent - 20) > 1e-3 || worth.change_known > 1e-3)
        fail_msg("%g, known to %g", worth.change_percent, worth.change_known);
    assert_true(worth_of(&base, find_term(terms, count, "hits beyond the first"), NULL, &worth, &error));
    assert_true(worth.change_percent < 1e-3);
    assert_true(worth_of(&base, find_term(terms, count, "Mie scattering"), NULL, &worth, &error));
    assert_int_equal(worth.state, TERM_NONE);
    worth_end(&base);
    free(terms);
    scene_destroy(&scene);
    context_close(&context);
}

static Worth worth_named(WorthBase *base, const Term *terms, int count, const char *name) {
    Worth worth;
    Error error;
    if (!worth_of(base, find_term(terms, count, name), NULL, &worth, &error)) fail_msg("%s", error.text);
    return worth;
}

/* What the further orders are worth under an air that has them. The ground is not seen, but it lights the
 * air. Degree 14 changes little, and its tables take longer. */
static void test_orders(void **state) {
    (void)state;
    Context context;
    Scene scene;
    Error error;
    WorthBase base;
    int count;
    support_open(&context);
    assert_true(scene_read(&scene, "scenes/crater.glsl", "glsl", &error));
    scene.values.atmosphere.orders = INFINITY;
    RenderParams params = {
        .scene = &scene, .further = "harmonics:8", .width = 8, .height = 8, .error_percent = 1};
    Term *terms = term_list(&params, &count);
    if (!worth_begin(&base, &context, &params, 16, NULL, &error)) fail_msg("%s", error.text);
    Worth orders = worth_named(&base, terms, count, "further orders of scattering");
    Worth ground = worth_named(&base, terms, count, "light from the ground");
    Worth harmonics = worth_named(&base, terms, count, "harmonics beyond degree 10");
    assert_int_equal(orders.state, TERM_ON);
    assert_int_equal(ground.state, TERM_OFF);
    assert_int_equal(harmonics.state, TERM_OFF);
    if (!(orders.change_percent > 25 && orders.change_percent < 60)) fail_msg("%g", orders.change_percent);
    if (!(ground.change_percent > 3 && ground.change_percent < 15)) fail_msg("%g", ground.change_percent);
    if (!(harmonics.change_percent < 1)) fail_msg("%g", harmonics.change_percent);
    assert_true(orders.once_seconds > 0 && harmonics.once_seconds > 0);
    worth_end(&base);
    free(terms);
    scene_destroy(&scene);
    context_close(&context);
}

static char *flattened(const char *arguments) {
    support_expect(0, "", "flatten %s", arguments);
    return strdup(support_out);
}

/* Each with and without: so that a word that is misspelt here is noticed. */
static void test_only_what_is_used(void **state) {
    (void)state;
    static const struct {
        const char *with, *without, *words;
    } cases[] = {
        {"scenes/crater.glsl --atmosphere simmons2017-ozone --sky gauss", "scenes/crater.glsl --sky gauss",
         "a.ozone_half_width_m"},
        {"scenes/crater.glsl --sun-disk", "scenes/crater.glsl", "sphere_reflection("},
        {"scenes/crater.glsl --sun-disk", "scenes/crater.glsl", "sun_disk_table"},
        {"scenes/materials.glsl", "scenes/crater.glsl", "MATERIAL_GLASS"},
        {"scenes/materials.glsl", "scenes/crater.glsl", "rough_metal"},
        {"scenes/gyroid.glsl", "scenes/crater.glsl", "void march("},
        {"scenes/crater.glsl", "scenes/gyroid.glsl", "hit_plane_minus_sphere"},
        {"scenes/crater.glsl --light mis", "scenes/crater.glsl", "sky_cells"},
        {"scenes/crater.glsl --sky gauss", "scenes/crater.glsl", "gauss_table"},
        {"scenes/crater.glsl", "scenes/crater.glsl --sequence random", "scramble_reversed("},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *with = flattened(cases[i].with), *without = flattened(cases[i].without);
        if (!strstr(with, cases[i].words)) fail_msg("%s: no '%s'", cases[i].with, cases[i].words);
        if (strstr(without, cases[i].words)) fail_msg("%s: '%s'", cases[i].without, cases[i].words);
        free(with);
        free(without);
    }
}

/* A library that grows by what a scene does not use makes the same shader, byte by byte: so it costs nothing.
 */
static void test_library_grows(void **state) {
    (void)state;
    char command[2048], arguments[1024];
    snprintf(command, sizeof command,
             "cp -r glsl '%s' && cd '%s' && echo 'float more() { return 1.0; }' >shape/more.glsl && "
             "cp shape/more.glsl material/more.glsl && for file in material/glass sky/paper shape/torus "
             "sun/mirrors sky/absorber_ozone; do cat shape/more.glsl >>$file.glsl; done",
             support_path("library"), support_path("library"));
    assert_int_equal(system(command), 0);
    char *before = flattened("scenes/crater.glsl");
    snprintf(arguments, sizeof arguments, "scenes/crater.glsl --glsl-dir '%s'", support_path("library"));
    char *after = flattened(arguments);
    assert_true(strlen(before) > 10000);
    assert_string_equal(before, after);
    snprintf(arguments, sizeof arguments, "scenes/materials.glsl --glsl-dir '%s'", support_path("library"));
    char *used = flattened(arguments);
    assert_non_null(strstr(used, "float more()"));
    free(before);
    free(after);
    free(used);
    snprintf(command, sizeof command, "rm -r '%s'", support_path("library"));
    assert_int_equal(system(command), 0);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_crater),        cmocka_unit_test(test_orders),
        cmocka_unit_test(test_files),         cmocka_unit_test(test_furnace),
        cmocka_unit_test(test_change),        cmocka_unit_test(test_only_what_is_used),
        cmocka_unit_test(test_library_grows),
    };
    return cmocka_run_group_tests_name("explain", tests, support_folder, support_clean);
}
