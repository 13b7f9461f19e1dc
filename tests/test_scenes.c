/* All scenes that are shipped: what each has to tell, every light method on each, what a library that grows
 * means to them, no leaks, and the default estimator against the plainest one. */
#include "scene_list.h"
#include "spread.h"
#include "support.h"

#include "base/file.h"
#include "choice/method.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static SceneList list;
static char (*const paths)[288] = list.paths;
static int scenes;

static int find_scenes(void **state) {
    list = scene_list();
    scenes = list.count;
    return support_folder(state);
}

static bool is(const char *path, const char *name) {
    const char *file = strrchr(path, '/') + 1;
    return strncmp(file, name, strlen(name)) == 0 && strcmp(file + strlen(name), ".glsl") == 0;
}

/* Renders a scene file to an image; its run's words are left in support_err. */
static Image render(const char *path, const char *arguments) {
    Image image;
    Error error;
    int status = support_run("", "render '%s' %s --progress json -o '%s'", path, arguments,
                             support_path("picture.pfm"));
    if (status == STATUS_NO_GL) support_no_gl(support_err);
    if (status != 0) fail_msg("%s %s: %s", path, arguments, support_err);
    if (!image_read(&image, support_path("picture.pfm"), &error)) fail_msg("%s", error.text);
    return image;
}

/* ---- What each scene has to tell */

static void expect_sun(const Scene *scene, const char *preset, double elevation) {
    Scene trial = *scene;
    Error error;
    if (!scene_choose_preset(&trial, preset, &error)) fail_msg("%s", error.text);
    if (trial.values.sun.elevation_deg != elevation)
        fail_msg("%s: preset %s: sun at %g", scene->file->path, preset, trial.values.sun.elevation_deg);
}

/* A title, what to look for, labels, and the three suns where the sky is the sun's. */
static void test_words(void **state) {
    (void)state;
    for (int i = 0; i < scenes; i++) {
        Scene scene;
        Error error;
        if (!scene_read(&scene, paths[i], "glsl", &error)) fail_msg("%s", error.text);
        if (!scene.file->title[0] || !scene.file->look[0])
            fail_msg("%s: no title or nothing to look for", paths[i]);
        for (int k = 0; k < scene.file->parameter_count; k++) {
            if (!scene.file->parameters[k].label[0])
                fail_msg("%s: %s has no label", paths[i], scene.file->parameters[k].name);
        }
        if (!scene.file->sky[0]) {
            expect_sun(&scene, "noon", 60);
            expect_sun(&scene, "sunset", 5);
            expect_sun(&scene, "twilight", -2);
        }
        scene_destroy(&scene);
    }
}

/* ---- Every light method on each */

/* A number of the last run's report; 0 where it has none of that name. */
static double reported(const char *name) {
    const char *at = strstr(support_err, "\"done\": true");
    at = at ? strstr(at, name) : NULL;
    return at ? strtod(at + strlen(name) + 2, NULL) : 0;
}

static void test_lights(void **state) {
    (void)state;
    for (int i = 0; i < scenes; i++) {
        double rays = 0, broken = 0, cut = 0, rejected = 0;
        int lights = 0;
        for (int k = 0; method_get(k); k++) {
            char arguments[128];
            if (method_get(k)->family != METHOD_LIGHT) continue;
            /* With few samples, as under the sanitizers, each scene takes one of the methods in turn. */
            if (support_block() > 1 && (lights++ + i) % 4) continue;
            /* A table, without which control is no choice; of an atmosphere that takes no time. */
            snprintf(arguments, sizeof arguments,
                     "--size 32x32 --spp 2 --sun 5 --atmosphere simmons2017 --sky table --light %s",
                     method_get(k)->name);
            Image image = render(paths[i], arguments);
            image_free(&image);
            rays += reported("search_rays");
            broken += reported("search_broken");
            cut += reported("search_cut");
            rejected += reported("rejected");
        }
        /* A ray along a wall for all of its length may be cut, once in millions. */
        if (rejected > 0 || broken > 0 || cut > 1)
            fail_msg("%s: %g samples rejected; of %g searches %g broken, %g cut", paths[i], rejected, rays,
                     broken, cut);
    }
}

/* ---- New shapes and materials */

/* A material's file, which does as matte does. */
#define MATERIAL_LIKE_MATTE(name, capitals)                                                                  \
    "#include \"material/matte.glsl\"\n"                                                                     \
    "Material " name "(vec3 albedo) { return material_new(MATERIAL_" capitals ", albedo); }\n"               \
    "Bounce " name "_sample(Material m, vec3 normal, vec3 incoming, vec2 u, vec2 v) {\n"                     \
    "    return matte_sample(m, normal, incoming, u, v);\n}\n"                                               \
    "float " name "_pdf(Material m, vec3 normal, vec3 incoming, vec3 outgoing) {\n"                          \
    "    return matte_pdf(m, normal, incoming, outgoing);\n}\n"                                              \
    "vec3 " name "_value(Material m, vec3 normal, vec3 incoming, vec3 outgoing) {\n"                         \
    "    return matte_value(m, normal, incoming, outgoing);\n}\n"

/* A copy of the library with a shape and a material more: a file each, and nothing else is changed. */
static const char *grow_library(void) {
    char command[1024];
    const char *library = support_path("library");
    snprintf(command, sizeof command, "cp -rL glsl '%s'", library);
    assert_int_equal(system(command), 0);
    support_write("library/material/chalk.glsl", MATERIAL_LIKE_MATTE("chalk", "CHALK"));
    support_write("library/shape/ball.glsl",
                  "#include \"shape/sphere.glsl\"\n"
                  "void hit_ball(Ray ray, vec3 foot, float radius, int object, INOUT(Hit) hit) {\n"
                  "    hit_sphere(ray, foot + vec3(0.0, radius, 0.0), radius, object, hit);\n}\n");
    return library;
}

static void remove_library(const char *library) {
    char command[1024];
    snprintf(command, sizeof command, "rm -r '%s'", library);
    assert_int_equal(system(command), 0);
}

static Text flatten(const char *path, const char *library) {
    Text text = {0};
    Error error;
    support_expect(0, "", "flatten '%s' --glsl-dir '%s'", path, library);
    if (!file_read(support_path("stdout"), STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    return text;
}

/* What a scene does not include is not there: no scene's text knows that the library has grown. */
static void test_grown_library(void **state) {
    (void)state;
    const char *library = grow_library();
    for (int i = 0; i < scenes; i++) {
        Text before = flatten(paths[i], "glsl"), after = flatten(paths[i], library);
        assert_true(before.size > 10000);
        assert_int_equal(before.size, after.size);
        assert_memory_equal(before.data, after.data, before.size);
        text_free(&before);
        text_free(&after);
    }
    remove_library(library);
}

/* A scene has the new shape and the new material by including their files. They do what two old ones do: the
 * picture is the same, to the bit. */
static void test_new_files(void **state) {
    (void)state;
    static const char *const words[2][3] = {{"sphere", "vec3(0.0, 0.7, 0.0), 0.7", "matte"},
                                            {"ball", "vec3(0.0), 0.7", "chalk"}};
    const char *library = "glsl";
    Image images[2];
    for (int k = 0; k < 2; k++) {
        char text[1024], arguments[1024];
        const char *const *word = words[k];
        if (k) library = grow_library();
        snprintf(text, sizeof text,
                 "//@ camera eye 0 1.5 -4 target 0 0.5 0 fov 50\n#include \"shape/plane.glsl\"\n"
                 "#include \"shape/%s.glsl\"\n#include \"material/%s.glsl\"\n#include "
                 "\"material/mirror.glsl\"\n"
                 "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                 "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n    hit_%s(ray, %s, 1, hit);\n}\n"
                 "Material scene_material(Hit hit) {\n"
                 "    return hit.object == 1 ? %s(vec3(0.8, 0.5, 0.2)) : mirror(vec3(0.5));\n}\n",
                 word[0], word[2], word[0], word[1], word[2]);
        snprintf(arguments, sizeof arguments, "--size 48x36 --spp 16 --glsl-dir '%s'", library);
        images[k] = render(support_write("grown.glsl", text), arguments);
    }
    assert_memory_equal(images[0].rgba, images[1].rgba, (size_t)4 * 48 * 36 * sizeof *images[0].rgba);
    for (int k = 0; k < 2; k++) image_free(&images[k]);
    remove_library(library);
}

/* ---- No leaks */

/* A scene file with lines before and after it. Its own functions may have been renamed by the first. */
static const char *wrapped(const char *path, const char *before, const char *after) {
    Text text = {0}, file = {0};
    Error error;
    if (!file_read(path, STATUS_FAILURE, &file, &error)) fail_msg("%s", error.text);
    text_append(&file, "", 0);
    text_print(&text, "%s%s\n%s", before, text_string(&file), after);
    const char *copy = support_write("wrapped.glsl", text_string(&text));
    text_free(&file);
    text_free(&text);
    return copy;
}

/* The mean is within its standard error as the pixels scatter, and no pixel is off by so much that it could
 * be looking through a hole. `comparisons`: how many means the test looks at. */
static void expect_white(const char *path, const Image *image, int comparisons) {
    double mean = 0, square = 0, worst = 0;
    int pixels = image->width * image->height;
    for (int k = 0; k < pixels; k++) {
        double off = (double)image->rgba[4 * k] - 1;
        mean += off / pixels;
        square += off * off / pixels;
        worst = fmax(worst, fabs(off));
    }
    /* 1e-7: floats near 1 are 6e-8 apart. */
    bool ok = ztest_difference(path, mean, square / pixels + 1e-14, 1, comparisons);
    print_message("%s: worst pixel %.3f\n", path, worst);
    support_table("furnaces", "| %s | %+.1e | %.1e | %.3f |", path, mean,
                  ztest_difference_limit(square / pixels + 1e-14, comparisons), worst);
    assert_true(ok && worst < 0.3);
}

/* Mist absorbs, so that a scene that has it is looked at without. */
static bool begins_with_mist(const char *path) {
    Scene scene;
    Error error;
    if (!scene_read(&scene, path, "glsl", &error)) fail_msg("%s", error.text);
    bool mist = scene_has_mist(&scene);
    scene_destroy(&scene);
    return mist;
}

/* The scene white all over, and black where a ray meets a surface from within a solid, which no ray can that
 * starts outside of all. Under a sky of 1 every pixel is 1 but for what roulette does to long paths: a
 * survivor of n hits counts 0.95^-(n - 3). Lost are paths that leak, end in a solid, or have no direction to
 * go on. */
static void test_furnace(void **state) {
    (void)state;
    static const char before[] = "#define scene_material scene_own_material\n";
    static const char glowing[] = "#undef scene_material\n#include \"material/glow.glsl\"\n"
                                  "Material scene_material(Hit hit) {\n"
                                  "    return glow(vec3(hit.inside && !two_sided(hit) ? 0.0 : 0.5));\n}\n";
    static const char after[] = "#undef scene_material\n#include \"material/matte.glsl\"\n"
                                "Material scene_material(Hit hit) {\n"
                                "    bool leaked = hit.inside && !two_sided(hit);\n"
                                "    return matte(vec3(leaked ? 0.0 : 1.0));\n}\n";
    assert_int_equal(mkdir(support_path("material"), 0777), 0);
    const char *material = support_write(
        "material/glow.glsl",
        MATERIAL_LIKE_MATTE(
            "glow",
            "GLOW") "vec3 glow_emitted(Material m, vec3 normal, vec3 incoming) { return m.color; }\n");
    for (int i = 0; i < scenes; i++) {
        Text end = {0};
        /* Rooms glow: what emits a half and reflects a half is 1 too, however few paths get out. In a box all
         * hits are from within. Paths stay in the holes of a sponge or a gasket for long, too: one that gets
         * out after 140 hits counts a thousand times. */
        bool room = is(paths[i], "house") || is(paths[i], "author-room") || is(paths[i], "box-room") ||
                    is(paths[i], "shafts") || is(paths[i], "menger") || is(paths[i], "apollonian");
        text_print(&end, "bool two_sided(Hit hit) { return %s; }\n%s",
                   is(paths[i], "shapes")     ? "hit.object == DISK"
                   : is(paths[i], "box-room") ? "hit.object == WALLS"
                                              : "false",
                   room ? glowing : after);
        const char *scene = wrapped(paths[i], before, text_string(&end));
        char arguments[256];
        snprintf(arguments, sizeof arguments,
                 "--size 64x48 --spp 128 --sky uniform --light cosine --sun-disk=off%s",
                 begins_with_mist(paths[i]) ? " --set mist=off" : "");
        Image image = render(scene, arguments);
        expect_white(paths[i], &image, scenes);
        text_free(&end);
        image_free(&image);
    }
    unlink(material);
    rmdir(support_path("material"));
}

/* A house with its window bricked up is dark: walls that run into each other leave no seam for a ray. */
static void test_closed_house(void **state) {
    (void)state;
    const char *scene =
        wrapped("scenes/house.glsl", "#define scene_intersect scene_own_intersect\n",
                "#undef scene_intersect\n"
                "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                "    scene_own_intersect(ray, hit);\n"
                "    hit_box(ray, vec3(-2.3, 1.5, 0.0), vec3(0.1, 0.7, 1.5), WALL, hit);\n}\n");
    Image image = render(scene, "--size 64x48 --spp 256 --sky uniform --light cosine");
    for (int k = 0; k < 64 * 48; k++) assert_true(image.rgba[4 * k] == 0);
    image_free(&image);
}

/* ---- Marched and exact */

/* The ball of the scene below, on even ground. */
static const char marched_ball[] =
    "//@ camera eye 0 1.5 -4 target 0 0.8 0 fov 50\n"
    "#include \"distance/sphere.glsl\"\n#include \"material/matte.glsl\"\n#include \"shape/march.glsl\"\n"
    "#include \"shape/plane.glsl\"\n#include \"shape/sphere.glsl\"\n"
    "uniform bool marched; //@ checkbox off\n"
    "float scene_distance(vec3 p) { return distance_sphere(p, vec3(0.0, 1.0, 0.0), 1.0); }\n"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
    "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"
    "    if (marched) march(ray, vec3(0.0, 1.0, 0.0), 1.0, 1, hit);\n"
    "    else hit_sphere(ray, vec3(0.0, 1.0, 0.0), 1.0, 1, hit);\n}\n"
    "Material scene_material(Hit hit) { return matte(hit.object == 1 ? vec3(0.8, 0.3, 0.2) : vec3(0.5)); }\n";

/* A ball marched and the same ball hit exactly give the same picture, by the same random numbers: the same
 * paths, but for those of which a later ray passes the ball's outline on the other side. */
static void test_marched_ball(void **state) {
    (void)state;
    enum { ACROSS = 96, DOWN = 72 };
    static const char same[] =
        "--size 96x72 --spp 64 --sequence random --light cosine --sun 30 --set marched=";
    const char *scene = support_write("ball.glsl", marched_ball);
    Image edges = render(scene, "--size 96x72 --spp 1024 --sky uniform"), images[2];
    double light = 0, difference = 0;
    int counted = 0, near = 0;
    for (int k = 0; k < 2; k++) {
        char arguments[128];
        snprintf(arguments, sizeof arguments, "%s%d", same, k);
        images[k] = render(scene, arguments);
    }
    for (int i = 0; i < 3 * ACROSS * DOWN; i++) {
        int x = i / 3 % ACROSS, y = i / 3 / ACROSS;
        double exact = (double)images[0].rgba[4 * (i / 3) + i % 3];
        double marched = (double)images[1].rgba[4 * (i / 3) + i % 3];
        light += exact;
        difference += marched - exact;
        if (x < 2 || x > ACROSS - 3 || y < 2 || y > DOWN - 3 || !spread_even_around(&edges, x, y)) continue;
        near += fabs(marched - exact) < 1e-4 * exact;
        counted++;
    }
    print_message("a ball, marched: %.2f %% of %d values off edges within 1e-4, means differ by %.1e\n",
                  100.0 * near / counted, counted, difference / light);
    assert_true(counted > ACROSS * DOWN && near > 0.98 * counted && fabs(difference) < 1e-5 * light);
    for (int k = 0; k < 2; k++) image_free(&images[k]);
    image_free(&edges);
}

/* ---- The default estimator against the plainest */

/* Sky only, as auto chooses, and by Lambert's cosine with independent numbers. The noise of either is
 * measured from seeds. */
static void test_estimators(void **state) {
    (void)state;
    static Spread plain, usual;
    static const char common[] = "--size 48x36 --spp 64 --sun-disk=off";
    for (int i = 0; i < scenes; i++) {
        char arguments[128];
        snprintf(arguments, sizeof arguments, "%s --light cosine --sequence random", common);
        spread_render(paths[i], arguments, 0, &plain);
        spread_render(paths[i], common, 100, &usual);
        spread_expect_same(paths[i], &usual, &plain, scenes, NULL);
    }
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_words),         cmocka_unit_test(test_lights),
        cmocka_unit_test(test_grown_library), cmocka_unit_test(test_new_files),
        cmocka_unit_test(test_furnace),       cmocka_unit_test(test_closed_house),
        cmocka_unit_test(test_marched_ball),  cmocka_unit_test(test_estimators),
    };
    return cmocka_run_group_tests_name("scenes", tests, find_scenes, support_clean);
}
