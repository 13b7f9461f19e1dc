/* --nan-map: which samples were left out, and why. */
#include "support.h"

#include "image/format.h"
#include "image/read_params.h"

#include <math.h>
#include <string.h>

/* Four stripes from left to right: no number, too bright for a sum, below nothing, and a good one. The edges
 * between them lie on edges of pixels in a picture of 32 columns. */
static const char *stripes(void) {
    return support_write("stripes.glsl",
                         "//@ camera eye 0 0 -4 target 0 0 0 fov 90\n#include \"material/emitter.glsl\"\n"
                         "#include \"shape/plane.glsl\"\n"
                         "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                         "    hit_plane(ray, vec3(0.0, 0.0, -1.0), 0.0, 0, hit);\n}\n"
                         "Material scene_material(Hit hit) {\n"
                         "    float x = -hit.position.x;\n"
                         "    if (x < -2.0) return emitter(vec3(sqrt(x)));\n"
                         "    return emitter(vec3(x < 0.0 ? 3.0e38 : x < 2.0 ? -1.0 : 1.0));\n}\n");
}

static Image read_layer(const char *path, const char *layer) {
    Image image;
    Error error;
    ImageReadParams params = {.layer = layer};
    if (!image_read_as(&image, path, &params, &error)) fail_msg("%s: %s", layer, error.text);
    return image;
}

/* Expects `count` in the pixels of that stripe, or of the one mirrored, and 0 in all others. */
static void expect_stripe(const char *path, const char *layer, int stripe, float count) {
    Image image = read_layer(path, layer);
    for (int i = 0; i < image.width * image.height; i++) {
        int column = i % image.width * 4 / image.width;
        assert_true(image.rgba[4 * i] == (column == stripe ? count : 0));
    }
    image_free(&image);
}

/* Each cause is counted where it is and nowhere else, and the picture is the same with the map and without.
 */
static void test_causes(void **state) {
    (void)state;
    const char *map = support_path("map.exr"), *with = support_path("with.pfm"),
               *without = support_path("without.pfm"), *scene = stripes();
    support_expect(0, "", "render '%s' --size 32x32 --spp 48 --light cosine -o '%s' --nan-map '%s'", scene,
                   with, map);
    support_expect(0, "", "render '%s' --size 32x32 --spp 48 --light cosine -o '%s'", scene, without);
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 0", with, without);
    expect_stripe(map, "not_finite", 0, 48);
    expect_stripe(map, "too_large", 1, 48);
    expect_stripe(map, "negative", 2, 48);
    expect_stripe(map, "loops", -1, 0);
    expect_stripe(map, "points", -1, 0);
    support_expect(0, "", "render '%s' --size 32x32 --spp 16 --sequence metropolis -o '%s' --nan-map '%s'",
                   scene, with, map);
    Image points = read_layer(map, "points");
    double sum = 0;
    for (int i = 0; i < points.width * points.height; i++) sum += (double)points.rgba[4 * i];
    assert_true(sum > 0);
    image_free(&points);
}

/* The sum of the map is what the warning says, also where tiles have different numbers of samples. */
static void test_sum(void **state) {
    (void)state;
    const char *map = support_path("sum.exr");
    support_run("", "render '%s' --size 32x32 --error 5 --progress json -o '%s' --nan-map '%s'", stripes(),
                support_path("sum.pfm"), map);
    double rejected = support_figure("rejected"), sum = 0;
    static const char *const layers[] = {"not_finite", "too_large", "loops"};
    for (int k = 0; k < 3; k++) {
        Image image = read_layer(map, layers[k]);
        for (int i = 0; i < image.width * image.height; i++) sum += (double)image.rgba[4 * i];
        image_free(&image);
    }
    assert_true(rejected > 0 && sum == rejected);
}

static void test_refusals(void **state) {
    (void)state;
    const char *scene = stripes(), *out = support_path("out.exr");
    support_expect(STATUS_USAGE, "--nan-map: map.png is no .exr", "render '%s' -o '%s' --nan-map map.png",
                   scene, out);
    support_expect(STATUS_USAGE, "is the picture of -o already", "render '%s' -o '%s' --nan-map '%s'", scene,
                   out, out);
    support_expect(STATUS_USAGE, "--nan-map: standard output", "render '%s' -o '%s' --nan-map -", scene, out);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_causes),
        cmocka_unit_test(test_sum),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests_name("nan_map", tests, support_folder, support_clean);
}
