/* Sunlight that only chance finds, as `render` tells it: how much there is, and what throws it. */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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
                          support_figure("chance_light_percent"));
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
        chance[named] = support_figure("chance_light_percent");
        assert_true(support_figure("chance_paths_percent") > 0 &&
                    support_figure("chance_pixels_percent") > 0);
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
    assert_true(support_figure("chance_paths_percent") < 0); /* nothing is counted */
    if (!image_read(&image, out, &error)) fail_msg("%s", error.text);
    double irradiance = luminance(image.rgba) * acos(-1) / sin(50 * degree);
    image_free(&image);
    snprintf(text, sizeof text, scene, "", "mirror(vec3(0.9))");
    support_expect(0, "found by chance",
                   "render '%s' --size 16x16 --spp 16 --sky uniform:1 --sun-disk --progress json -o '%s'",
                   support_write("mirror.glsl", text), out);
    double light = support_figure("chance_light_percent"), expected = irradiance / solid_angle;
    print_message("in a mirror: light by chance is %.4g of the other light, reckoned %.4g\n",
                  light / (100 - light), expected);
    assert_true(support_figure("chance_paths_percent") == 100 &&
                support_figure("chance_pixels_percent") == 100);
    assert_true(fabs(light / (100 - light) / expected - 1) < 0.01);
    /* A flat mirror that is named shows the sun as large as it is, and leaves nothing to chance. */
    snprintf(text, sizeof text, scene, "//@ mirror-plane 0 90\n", "mirror(vec3(0.9))");
    support_expect(0, "",
                   "render '%s' --size 16x16 --spp 16 --sky uniform:1 --sun-disk --progress json -o '%s'",
                   support_write("named.glsl", text), out);
    assert_null(strstr(support_err, "chance"));
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_chance),
        cmocka_unit_test(test_partly_named),
        cmocka_unit_test(test_chance_by_hand),
        cmocka_unit_test(test_own_material_by_chance),
    };
    return cmocka_run_group_tests_name("chance", tests, support_folder, support_clean);
}
