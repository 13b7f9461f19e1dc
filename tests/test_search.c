/* What goes wrong in searches of distance fields is noticed, counted and said. */
#include "support.h"

#include "gl/loops.h"
#include "image/format.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char scene[] = "//@ camera eye 0 1 -4 target 0 0.5 0 fov 60\n"
                            "#include \"material/matte.glsl\"\n"
                            "#include \"shape/march.glsl\"\n"
                            "#include \"shape/plane.glsl\"\n"
                            "uniform int none = 0;\n"
                            "float scene_distance(vec3 p) { %s }\n"
                            "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                            "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"
                            "    march(ray, 1, hit);\n"
                            "}\n"
                            "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n";

#define BALL "length(p - vec3(0.0, 1.0, 0.0)) - 0.5"

/* Renders a scene; what was said is in support_err. */
static void render_text(const char *text, const char *options) {
    const char *path = support_write("field.glsl", text), *out = support_path("field.exr");
    int status = support_run("", "render '%s' -o '%s' --size 32x32 --sky uniform -v --progress json %s", path,
                             out, options);
    if (status) {
        size_t length = strlen(support_err);
        fail_msg("exit status %d: ... %s", status, support_err + (length > 600 ? length - 600 : 0));
    }
}

/* The largest value of the picture. */
static float brightest(void) {
    Image image;
    Error error;
    float most = 0;
    if (!image_read(&image, support_path("field.exr"), &error)) fail_msg("%s", error.text);
    for (size_t i = 0; i < 4 * (size_t)image.width * (size_t)image.height; i++)
        most = fmaxf(most, image.rgba[i]);
    image_free(&image);
    return most;
}

static void render(const char *body, const char *options) {
    char text[2048];
    snprintf(text, sizeof text, scene, body);
    render_text(text, options);
}

static void test_honest(void **state) {
    (void)state;
    render("return " BALL ";", "--spp 4");
    double rays = support_figure("search_rays"), steps = support_figure("search_steps");
    print_message("a ball: %g rays, %.1f steps each\n", rays, steps / rays);
    assert_true(rays >= 32 * 32 * 4 && steps / rays > 1 && steps / rays < 40);
    assert_true(support_figure("search_broken") == 0 && support_figure("search_cut") == 0 &&
                support_figure("rejected") == 0);
    assert_null(strstr(support_err, "warning"));
}

static void test_steep(void **state) {
    (void)state;
    render("return 3.0 * (" BALL ");", "--spp 4");
    assert_true(support_figure("search_broken") > 100);
    assert_non_null(strstr(support_err, "field.glsl"));
    assert_non_null(strstr(support_err, "changes faster than the distance"));
}

/* A field that is no number away from its surface, as where a root is taken of what may be negative. */
static void test_no_number(void **state) {
    (void)state;
    render("vec3 q = p - vec3(0.0, 1.0, 0.0); return sqrt(0.3 - dot(q, q)) - 0.2;", "--spp 4");
    assert_true(support_figure("search_broken") > 0.9 * support_figure("search_rays") &&
                support_figure("rejected") == 0);
    assert_non_null(strstr(support_err, "or is no number"));
}

/* A field that is tiny everywhere: no surface in any number of steps. */
static void test_cut(void **state) {
    (void)state;
    render("return 1.0e-5 * (" BALL ");", "--spp 1");
    assert_true(support_figure("search_cut") > 100);
    assert_non_null(strstr(support_err, "were cut"));
}

/* Where normals are blended at sharp edges, no bounce goes on within the solid: what is seen from inside
 * shines so brightly that one path would show. A path that begins inside still finds its way out, so that the
 * shine is there to be seen. */
static void test_edges(void **state) {
    static const char text[] =
        "//@ camera eye %s target 0 0.9 0 fov 40\n"
        "#include \"distance/boolean.glsl\"\n#include \"distance/box.glsl\"\n#include "
        "\"distance/sphere.glsl\"\n"
        "#include \"material/emitter.glsl\"\n#include \"material/matte.glsl\"\n#include "
        "\"shape/march.glsl\"\n"
        "float scene_distance(vec3 p) {\n"
        "    vec3 q = p - vec3(0.0, 1.0, 0.0);\n"
        "    float bowl = op_subtraction(distance_sphere(q, vec3(0.0), 0.6), distance_sphere(q, vec3(0.0, "
        "0.2, 0.0), 0.55));\n"
        "    return op_subtraction(bowl, distance_box(q, vec3(0.5, 0.0, 0.0), vec3(0.3)));\n}\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) { march(ray, vec3(0.0, 1.0, 0.0), 2.0, 1, hit); }\n"
        "Material scene_material(Hit hit) {\n"
        "    if (hit.inside) return emitter(vec3(1.0e7));\n    return matte(vec3(0.9));\n}\n";
    char scene_text[2048];
    (void)state;
    snprintf(scene_text, sizeof scene_text, text, "0 0.5 0");
    render_text(scene_text, "--spp 256 --size 64x64 --light cosine");
    assert_true(brightest() > 100);
    snprintf(scene_text, sizeof scene_text, text, "0 2 -3");
    render_text(scene_text, "--spp 256 --size 64x64 --light cosine");
    print_message("%.0f paths, the brightest pixel has %g\n", 64 * 64 * 256.0, brightest());
    assert_true(brightest() < 1.5);
}

/* The field has loops of its own, which nobody counted. A driver that ends all loops after so many iterations
 * does it without a word: then no sample counts, and it is said. A driver without a limit draws the picture.
 * The field is evaluated some 3,000 times, so that it is done in no time. */
static void test_loops(void **state) {
    (void)state;
    Context context;
    Error error;
    long limit;
    support_open(&context);
    if (!loops_probe(&context.gl, &limit, &error)) fail_msg("%s", error.text);
    context_close(&context);
    render("float d = " BALL "; int i = 0; do { i++; d += float(none); } while (i < 30000 + none); return d;",
           "--spp 1 --size 8x8 --depth 1");
    print_message("limit %ld: %g of 64 samples rejected\n", limit, support_figure("rejected"));
    assert_true(support_figure("rejected") == (limit ? 64 : 0));
    assert_int_equal(strstr(support_err, "more loops than the driver allows") != NULL, limit != 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_honest), cmocka_unit_test(test_steep), cmocka_unit_test(test_no_number),
        cmocka_unit_test(test_edges),  cmocka_unit_test(test_cut),   cmocka_unit_test(test_loops),
    };
    return cmocka_run_group_tests_name("search", tests, support_folder, support_clean);
}
