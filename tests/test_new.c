/* A newcomer's first hour: a scene to begin with, and an error that says which file to include. */
#include "support.h"

#include "base/file.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

static void check_scene(const char *kind, bool is_toy) {
    const char *path = support_path("my-first_scene.glsl"), *picture = support_path("first.exr");
    Text text = {0};
    Error error;
    unlink(path);
    support_expect(0, "", "new '%s' --kind %s", path, kind);
    assert_non_null(strstr(support_out, "magichour view "));
    if (!file_read(path, STATUS_SCENE, &text, &error)) fail_msg("%s", error.text);
    assert_null(strstr(text_string(&text), "TITLE"));
    assert_null(strstr(text_string(&text), "FILE"));
    if (!is_toy) assert_non_null(strstr(text_string(&text), "//@ title   my first scene\n"));
    support_expect(0, "", "render '%s' -o '%s' --size 32x20 %s --quiet", path, picture,
                   is_toy ? "" : "--spp 4");
    if (!is_toy) support_expect(0, "", "export '%s' -o '%s'", path, support_path("first.html"));
    text_free(&text);
}

static void test_kinds(void **state) {
    (void)state;
    check_scene("exact", false);
    check_scene("marched", false);
    check_scene("shadertoy", true);
}

/* Nothing is lost: a file that is there stays as it is. */
static void test_refusals(void **state) {
    (void)state;
    const char *path = support_write("mine.glsl", "my own words\n");
    Text text = {0};
    Error error;
    support_expect(5, "mine.glsl: there is such a file already; nothing was written", "new '%s'", path);
    if (!file_read(path, STATUS_SCENE, &text, &error)) fail_msg("%s", error.text);
    assert_string_equal(text_string(&text), "my own words\n");
    text_free(&text);
    /* The ending is added. */
    char *dot = strrchr(path, '.');
    support_expect(5, "there is such a file already", "new '%.*s'", (int)(dot - path), path);
    support_expect(5, "/nowhere/a.glsl", "new /nowhere/a");
    support_expect(2, "--kind", "new '%s' --kind round", support_path("other"));
    support_expect(2, "", "new");
}

/* A name of the library's that is not included is told with its file; a name that nobody has is not. */
static void test_missing_include(void **state) {
    (void)state;
    static const struct {
        const char *call, *file;
    } rows[] = {{"hit_sphere(ray, vec3(0.0), 1.0, 0, hit)", "shape/sphere.glsl"},
                {"hit_box(ray, vec3(0.0), vec3(1.0), 0, hit)", "shape/box.glsl"},
                {"hit.t = distance_torus(ray.origin, vec3(0.0), vec3(0.0, 1.0, 0.0), 1.0, 0.1)",
                 "distance/torus.glsl"},
                {"hit.t = op_smooth_union(1.0, 2.0, 0.1)", "distance/smooth.glsl"},
                {"hit.normal = checker(ray.origin, vec3(1.0), vec3(0.0))", "color/checker.glsl"}};
    char part[200];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Text scene = {0};
        text_print(
            &scene,
            "#include \"material/matte.glsl\"\nvoid scene_intersect(Ray ray, INOUT(Hit) hit) {\n    %s;\n}\n"
            "Material scene_material(Hit hit) {\n    return matte(vec3(0.5));\n}\n",
            rows[i].call);
        const char *path = support_write("lacks.glsl", text_string(&scene));
        snprintf(part, sizeof part, ": it needs #include \"%s\"", rows[i].file);
        support_expect(3, part, "render '%s' --size 8x8 --spp 1 -o '%s'", path, support_path("out.exr"));
        assert_non_null(strstr(support_err, "lacks.glsl:3: "));
        text_free(&scene);
    }
    const char *path = support_write(
        "lacks.glsl", "#include \"material/matte.glsl\"\nvoid scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                      "    hit_potato(ray);\n}\nMaterial scene_material(Hit hit) {\n    return "
                      "matte(vec3(0.5), 1.0);\n}\n");
    support_expect(3, "lacks.glsl:3: ", "render '%s' --size 8x8 --spp 1 -o '%s'", path,
                   support_path("out.exr"));
    assert_null(strstr(support_err, "it needs #include"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_kinds), cmocka_unit_test(test_refusals),
                                       cmocka_unit_test(test_missing_include)};
    return cmocka_run_group_tests_name("new", tests, support_folder, support_clean);
}
