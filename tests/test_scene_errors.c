/* Faults in a scene's GLSL, each told with its file and line. */
#include "support.h"

#include <string.h>
#include <unistd.h>

#define TINY "--size 16x16 --spp 1 --sky uniform"
#define MATERIAL "Material scene_material(Hit hit) { return material_new(0, vec3(0)); }\n"
#define INTERSECT "void scene_intersect(Ray ray, INOUT(Hit) hit) { }\n"

static bool exists(const char *path) {
    return access(path, F_OK) == 0;
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

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scene_errors),
        cmocka_unit_test(test_included_error),
        cmocka_unit_test(test_clashes),
        cmocka_unit_test(test_unset),
    };
    return cmocka_run_group_tests_name("scene_errors", tests, support_folder, support_clean);
}
