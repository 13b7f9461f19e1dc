/* Closed solids seen from inside: a camera in a mirror or in rough metal under an even sky sees black, also
 * after 64 reflections, because no ray gets out. */
#include "studio.h"
#include "support.h"

#include <math.h>
#include <stdio.h>

/* Where rounding puts a hit on the wrong side of an edge, a ray gets out. Measured: 4e-5 of the light in the
 * cone, whose tip is thinner than rays are lifted off surfaces, and 2e-5 in the marched box, whose normals
 * are blended at edges. */
static const double edges = 2e-4;

static const struct {
    const char *name, *includes, *before, *call;
    double most;
} solids[] = {
    {"sphere", "sphere", "", "hit_sphere(ray, vec3(0.0), 0.5, 1, hit);", 0},
    {"spheres", "spheres", "//@ spheres 1\nvec4 scene_sphere(int i) { return vec4(0.0, 0.0, 0.0, 0.5); }\n",
     "hit_spheres(ray, 1, hit);", 0},
    {"far sphere", "sphere", "", "hit_sphere(ray, vec3(0.0, -90.0, 30.0), 100.0, 1, hit);", 0},
    {"box", "box", "", "hit_box(ray, vec3(0.0), vec3(0.5, 0.4, 0.6), 1, hit);", edges},
    {"rounded box", "rounded_box", "", "hit_rounded_box(ray, vec3(0.0), vec3(0.5, 0.4, 0.6), 0.1, 1, hit);",
     0},
    {"capsule", "capsule", "", "hit_capsule(ray, vec3(-0.1, -0.2, -0.1), vec3(0.1, 0.3, 0.4), 0.5, 1, hit);",
     0},
    {"cone", "cone", "", "hit_cone(ray, vec3(0.0, -0.5, 0.0), vec3(0.0, 1.5, 0.0), 1.0, 1, hit);", edges},
    {"cylinder", "cylinder", "", "hit_cylinder(ray, vec3(0.0, -0.5, 0.0), vec3(0.0, 0.5, 0.1), 0.6, 1, hit);",
     edges},
    {"ellipsoid", "ellipsoid", "", "hit_ellipsoid(ray, vec3(0.0), vec3(0.5, 0.4, 0.8), 1, hit);", 0},
    {"torus", "torus", "", "hit_torus(ray, vec3(0.0, 0.05, -0.8), vec3(0.0, 2.0, 0.0), 1.0, 0.4, 1, hit);",
     0},
    {"march", "march", "float scene_distance(vec3 p) { return length(p) - 0.5; }\n", "march(ray, 1, hit);",
     0},
    {"marched box", "march",
     "float scene_distance(vec3 p) {\n    vec3 q = abs(p) - vec3(0.5, 0.4, 0.6);\n"
     "    return length(max(q, vec3(0.0))) + min(max(q.x, max(q.y, q.z)), 0.0);\n}\n",
     "march(ray, 1, hit);", edges},
};

static double mean_inside(const char *material, const char *constructor, size_t solid) {
    char text[2048], name[64];
    snprintf(name, sizeof name, "%s%zu.glsl", material, solid);
    snprintf(text, sizeof text,
             "//@ camera eye 0.1 0.05 0.2 target 0.2 0.1 1 fov 60\n#include \"material/%s.glsl\"\n"
             "#include \"shape/%s.glsl\"\n%s"
             "void scene_intersect(Ray ray, INOUT(Hit) hit) { %s }\n"
             "Material scene_material(Hit hit) { return %s; }\n",
             material, solids[solid].includes, solids[solid].before, solids[solid].call, constructor);
    Studio studio;
    studio_open(&studio, support_write(name, text),
                "--size 64x64 --spp 16 --sky uniform:1 --light cosine --depth 64");
    Image image = studio_picture(&studio, 1);
    double sum = 0;
    size_t pixels = (size_t)image.width * (size_t)image.height;
    for (size_t i = 0; i < pixels; i++) sum += (double)image.rgba[4 * i] / (double)pixels;
    image_free(&image);
    studio_close(&studio);
    return sum;
}

static void check_all(const char *material, const char *constructor) {
    for (size_t i = 0; i < sizeof solids / sizeof *solids; i++) {
        double mean = mean_inside(material, constructor, i);
        print_message("%s, %s: %.2g\n", solids[i].name, material, mean);
        if (mean > solids[i].most) fail_msg("%s of %s leaks %g", solids[i].name, material, mean);
    }
}

static void test_mirror(void **state) {
    (void)state;
    check_all("mirror", "mirror(vec3(1.0))");
}

static void test_rough_metal(void **state) {
    (void)state;
    check_all("rough_metal", "rough_metal(vec3(1.0), 0.5)");
}

/* A surface that is not closed does let light through, so the tests above can fail. */
static void test_open(void **state) {
    (void)state;
    const char *scene = support_write(
        "open.glsl",
        "//@ camera eye 0.1 0.05 0.2 target 0.2 0.1 1 fov 60\n#include \"material/mirror.glsl\"\n"
        "#include \"shape/disk.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_disk(ray, vec3(0.0, 0.0, 2.0), "
        "vec3(0.0, 0.0, 1.0), 0.5, 1, hit); }\n"
        "Material scene_material(Hit hit) { return mirror(vec3(1.0)); }\n");
    Studio studio;
    studio_open(&studio, scene, "--size 16x16 --spp 1 --sky uniform:1 --light cosine --depth 64");
    Image image = studio_picture(&studio, 1);
    for (int i = 0; i < 16 * 16; i++) assert_true(fabsf(image.rgba[4 * i] - 1) < 0.01f);
    image_free(&image);
    studio_close(&studio);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_mirror), cmocka_unit_test(test_rough_metal),
                                       cmocka_unit_test(test_open)};
    return cmocka_run_group_tests_name("enclosure", tests, support_folder, support_clean);
}
