/* Values that no surface can have: they are put right, and said with the object and the number. */
#include "support.h"

#include "image/compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A ball on a plane. `far` is the place of both along x, in metres. */
static const char *scene_of(const char *name, const char *normal, const char *albedo, double far) {
    char text[2048];
    snprintf(
        text, sizeof text,
        "//@ camera eye %.9g 1 -4  target %.9g 0.5 0  fov 60\n#include \"material/matte.glsl\"\n"
        "#include \"shape/plane.glsl\"\n#include \"shape/sphere.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
        "    hit_plane(ray, %s, 0.0, 7, hit);\n    hit_sphere(ray, vec3(%.9f, 0.5, 0.0), 0.5, 8, hit);\n}\n"
        "Material scene_material(Hit hit) { return matte(hit.object == 8 ? %s : vec3(0.5)); }\n",
        far, far, normal, far, albedo);
    return support_write(name, text);
}

static Comparison compare(const char *a_path, const char *b_path) {
    Image a, b;
    Comparison result;
    CompareOptions options = {0};
    Error error;
    if (!image_read(&a, a_path, &error) || !image_read(&b, b_path, &error)) fail_msg("%s", error.text);
    if (!compare_images(&a, &b, &options, &result, &error)) fail_msg("%s", error.text);
    image_free(&a);
    image_free(&b);
    return result;
}

/* Renders the scene, which must end well, and gives the picture's path. What it warned of is in
 * support_err. */
static const char *render(const char *scene, const char *picture) {
    const char *path = support_path(picture);
    support_expect(0, "", "render '%s' -o '%s' --size 64x64 --spp 16 --quiet", scene, path);
    return path;
}

static void test_good(void **state) {
    (void)state;
    render(scene_of("good.glsl", "vec3(0.0, 1.0, 0.0)", "vec3(1.0, 0.0, 0.3)", 0), "good.pfm");
    assert_string_equal(support_err, "");
}

static void test_normals(void **state) {
    (void)state;
    static const struct {
        const char *normal, *length;
    } cases[] = {{"vec3(0.0, 3.0, 0.0)", "length 3;"}, {"vec3(0.0, 0.01, 0.0)", "length 0.01;"}};
    const char *good = render(scene_of("unit.glsl", "vec3(0.0, 1.0, 0.0)", "vec3(0.5)", 0), "unit.pfm");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *other = render(scene_of("long.glsl", cases[i].normal, "vec3(0.5)", 0), "long.pfm");
        assert_non_null(strstr(support_err, "object 7 has a normal of "));
        assert_non_null(strstr(support_err, cases[i].length));
        assert_true(compare(other, good).rel_rmse_percent < 0.1);
    }
}

static void test_albedos(void **state) {
    (void)state;
    const char *good =
        render(scene_of("one.glsl", "vec3(0.0, 1.0, 0.0)", "vec3(1.0, 0.0, 0.3)", 0), "one.pfm");
    const char *high =
        render(scene_of("high.glsl", "vec3(0.0, 1.0, 0.0)", "vec3(1.8, 0.0, 0.3)", 0), "high.pfm");
    assert_non_null(strstr(support_err, "object 8 has an albedo of 1.8;"));
    assert_true(compare(high, good).rel_rmse_percent == 0);
    const char *low =
        render(scene_of("low.glsl", "vec3(0.0, 1.0, 0.0)", "vec3(1.0, -0.2, 0.3)", 0), "low.pfm");
    assert_non_null(strstr(support_err, "object 8 has an albedo of -0.2;"));
    assert_true(compare(low, good).rel_rmse_percent == 0);
}

/* A lamp's radiance is no albedo. */
static void test_lamp(void **state) {
    (void)state;
    const char *scene = support_write(
        "lamp.glsl", "//@ camera eye 0 1 -4 target 0 0.5 0 fov 60\n#include \"material/emitter.glsl\"\n"
                     "#include \"shape/sphere.glsl\"\n"
                     "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_sphere(ray, vec3(0.0), "
                     "1.0, 1, hit); }\n"
                     "Material scene_material(Hit hit) { return emitter(vec3(50.0)); }\n");
    Image image;
    Error error;
    if (!image_read(&image, render(scene, "lamp.pfm"), &error)) fail_msg("%s", error.text);
    assert_string_equal(support_err, "");
    float largest = 0;
    for (int i = 0; i < 64 * 64; i++) largest = fmaxf(largest, image.rgba[4 * i]);
    assert_true(fabsf(largest - 50) < 1e-3f);
    image_free(&image);
}

/* Metal and glass of numbers that no metal and no glass has. */
static void test_others(void **state) {
    (void)state;
    static const struct {
        const char *material, *wrong, *right, *said;
    } cases[] = {{"rough_metal", "rough_metal(vec3(0.9), 1.5)", "rough_metal(vec3(0.9), 1.0)",
                  "object 1 has a roughness of 1.5;"},
                 {"rough_metal", "rough_metal(vec3(0.9), -0.5)", "rough_metal(vec3(0.9), 0.0)",
                  "object 1 has a roughness of -0.5;"},
                 {"glass", "glass(-1.5)", "glass(0.1)", "object 1 has an index of refraction of -1.5;"},
                 {"glass", "glass(0.0)", "glass(0.1)", "object 1 has an index of refraction of 0;"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *paths[2];
        for (int right = 0; right < 2; right++) {
            char text[1024];
            snprintf(
                text, sizeof text,
                "//@ camera eye 0 0.5 -4 target 0 0 0 fov 60\n#include \"material/%s.glsl\"\n"
                "#include \"shape/sphere.glsl\"\n"
                "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_sphere(ray, vec3(0.0), 1.0, 1, hit); }\n"
                "Material scene_material(Hit hit) { return %s; }\n",
                cases[i].material, right ? cases[i].right : cases[i].wrong);
            paths[right] = render(support_write("other.glsl", text), right ? "right.pfm" : "wrong.pfm");
            if (right)
                assert_string_equal(support_err, "");
            else if (!strstr(support_err, cases[i].said))
                fail_msg("%s: %s", cases[i].wrong, support_err);
        }
        assert_true(compare(paths[0], paths[1]).rel_rmse_percent == 0);
    }
}

/* The error of a scene far from the origin stays below what the warning says, and nothing is said where it is
 * small. */
static void test_far(void **state) {
    (void)state;
    static const struct {
        double far_m;
        bool said;
    } cases[] = {{1e3, false}, {3e4, true}, {1e5, true}, {1e6, true}};
    const char *here = support_path("here.pfm"), *there = support_path("there.pfm");
    const char *arguments = "--size 64x64 --spp 1024 --light cosine --quiet";
    support_expect(0, "", "render '%s' -o '%s' %s",
                   scene_of("here.glsl", "vec3(0.0, 1.0, 0.0)", "vec3(0.5)", 0), here, arguments);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        support_expect(0, "", "render '%s' -o '%s' %s",
                       scene_of("there.glsl", "vec3(0.0, 1.0, 0.0)", "vec3(0.5)", cases[i].far_m), there,
                       arguments);
        const char *said = strstr(support_err, "an error of up to ");
        double error = compare(there, here).rel_rmse_percent;
        double claimed = said ? strtod(said + strlen("an error of up to "), NULL) : 0.2;
        print_message("%g m: %.3g %%, said %.3g %%\n", cases[i].far_m, error, claimed);
        assert_true((said != NULL) == cases[i].said);
        assert_true(error < claimed);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_good),    cmocka_unit_test(test_normals),
                                       cmocka_unit_test(test_albedos), cmocka_unit_test(test_lamp),
                                       cmocka_unit_test(test_others),  cmocka_unit_test(test_far)};
    return cmocka_run_group_tests_name("check", tests, support_folder, support_clean);
}
