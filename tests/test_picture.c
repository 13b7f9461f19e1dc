/* Whole pictures: against another renderer's, against what must come out exactly, and against themselves on
 * other backends, threads and cuts. */
#include "support.h"

#include "base/file.h"
#include "image/compare.h"
#include "render/renderer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Image render(const char *environment, const char *arguments) {
    Image image;
    Error error;
    int status =
        support_run(environment, "render %s --quiet -o '%s'", arguments, support_path("picture.pfm"));
    if (status == STATUS_NO_GL) support_no_gl(support_err);
    if (status != 0) fail_msg("render %s: %s", arguments, support_err);
    if (!image_read(&image, support_path("picture.pfm"), &error)) fail_msg("%s", error.text);
    return image;
}

static Comparison compare(Image *a, Image *b) {
    Comparison comparison;
    Error error;
    if (!compare_images(a, b, NULL, &comparison, &error)) fail_msg("%s", error.text);
    assert_int_equal(comparison.nonfinite, 0);
    return comparison;
}

static void expect_equal(const char *environment_a, const char *arguments_a, const char *environment_b,
                         const char *arguments_b) {
    Image a = render(environment_a, arguments_a), b = render(environment_b, arguments_b);
    Comparison c = compare(&a, &b);
    if (c.largest_percent != 0) {
        fail_msg("%s %s and %s %s differ: relRMSE %g %%", environment_a, arguments_a, environment_b,
                 arguments_b, c.rel_rmse_percent);
    }
    image_free(&a);
    image_free(&b);
}

/* The crater by Mitsuba 3.9.1 under the converged sky (tests/data/README.md). By default the channels' means
 * agree to 0.3 %; the 64x16 sums' own bias is up to 1.3 %. */
static void test_references(void **state) {
    (void)state;
    static const struct {
        const char *arguments, *reference;
        double rmse, bias; /* bounds, percent */
    } cases[] = {
        {"--sun 30 --spp 256", "crater_el30_azz_sphere_sky.exr", 1.5, 0.3},
        {"--sun 5,90 --spp 256", "crater_el5_azx_sphere_sky.exr", 5, 0.3},
        {"--sun -2 --spp 256 --set ball=0", "crater_el-2_azz_nosphere_sky.exr", 1.5, 0.3},
        {"--sun 5,90 --spp 256 --light control", "crater_el5_azx_sphere_sky.exr", 2.5, 0.1},
        {"--sun 30 --spp 256 --light mis", "crater_el30_azz_sphere_sky.exr", 1.5, 0.1},
        {"--sun 30 --spp 64 --sky paper:64x16", "crater_el30_azz_sphere_sky.exr", 5, 2},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char arguments[256], path[128];
        Image reference;
        Error error;
        snprintf(arguments, sizeof arguments, "scenes/crater.glsl --depth 8 --size 256x256 %s",
                 cases[i].arguments);
        snprintf(path, sizeof path, "tests/data/%s", cases[i].reference);
        Image image = render("", arguments);
        if (!image_read(&reference, path, &error)) fail_msg("%s", error.text);
        Comparison c = compare(&image, &reference);
        print_message("%s: relRMSE %.2f %%, bias %+.3f %+.3f %+.3f %%\n", cases[i].arguments,
                      c.rel_rmse_percent, c.bias_percent[0], c.bias_percent[1], c.bias_percent[2]);
        assert_true(c.rel_rmse_percent < cases[i].rmse);
        for (int k = 0; k < 3; k++) assert_true(fabs(c.bias_percent[k]) < cases[i].bias);
        image_free(&image);
        image_free(&reference);
    }
}

/* The same with a sun, which is a point there: no image in the ball, and no caustic, which a scene that does
 * not name its mirror leaves to a chance that a disk of 0.01 degrees does not give. */
static void test_sunlit_reference(void **state) {
    (void)state;
    Text text = {0}, copy = {0};
    Image reference;
    Error error;
    char arguments[512];
    assert_true(file_read("scenes/crater.glsl", STATUS_FAILURE, &text, &error));
    text_append(&text, "", 0);
    const char *line = strstr(text.data, "//@ mirror-sphere");
    assert_non_null(line);
    text_print(&copy, "%.*s%s", (int)(line - text.data), text.data, strchr(line, '\n'));
    snprintf(arguments, sizeof arguments,
             "'%s' --depth 8 --size 256x256 --spp 256 --sun 30 --sun-disk=sampled --set sun.radius=0.01",
             support_write("crater.glsl", text_string(&copy)));
    Image image = render("", arguments);
    if (!image_read(&reference, "tests/data/crater_el30_azz_sphere_sun.exr", &error))
        fail_msg("%s", error.text);
    Comparison c = compare(&image, &reference);
    print_message("sunlit: relRMSE %.2f %%, bias %+.3f %+.3f %+.3f %%\n", c.rel_rmse_percent,
                  c.bias_percent[0], c.bias_percent[1], c.bias_percent[2]);
    assert_true(c.rel_rmse_percent < 2.5);
    for (int k = 0; k < 3; k++) assert_true(fabs(c.bias_percent[k]) < 0.3);
    image_free(&image);
    image_free(&reference);
    text_free(&text);
    text_free(&copy);
}

/* The table's own error in a picture: the same paths with the same sky, asked anew for each. */
static void test_table_in_picture(void **state) {
    (void)state;
    static const char *const suns[] = {"60", "5", "0", "-4"};
    for (int i = 0; i < 4; i++) {
        char arguments[2][256];
        for (int direct = 0; direct < 2; direct++) {
            snprintf(arguments[direct], sizeof arguments[direct],
                     "scenes/crater.glsl --size 256x256 --spp 16 --light cosine --sun %s --sky %s", suns[i],
                     direct ? "gauss:8" : "table");
        }
        Image table = render("", arguments[0]), direct = render("", arguments[1]);
        Comparison c = compare(&table, &direct);
        print_message("table against gauss:8 a path, sun %s: relRMSE %.4f %%\n", suns[i], c.rel_rmse_percent);
        assert_true(c.rel_rmse_percent < 0.3);
        image_free(&table);
        image_free(&direct);
    }
}

/* All albedos 1 in surroundings of radiance 1, unlimited depth: every pixel is 1. */
static void test_furnace(void **state) {
    (void)state;
    static const char *const methods[] = {"--light control",
                                          "--light cosine",
                                          "--light paper",
                                          "--light mis",
                                          "--light cosine --sequence random",
                                          "--light control --sequence additive"};
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        char arguments[256];
        double mean = 0, worst = 0;
        snprintf(arguments, sizeof arguments, "scenes/furnace.glsl --spp 1024 --size 128x128 %s", methods[i]);
        Image image = render("", arguments);
        int pixels = image.width * image.height;
        for (int k = 0; k < pixels; k++) {
            mean += (double)image.rgba[4 * k] / pixels;
            worst = fmax(worst, fabs((double)image.rgba[4 * k] - 1));
            assert_true(image.rgba[4 * k] == image.rgba[4 * k + 2]);
        }
        print_message("furnace, %s: mean %.6f, worst pixel %.4f off\n", methods[i], mean, worst);
        /* mis weighs its first bounces by 0 to 2. */
        bool weighed = strstr(methods[i], "mis") != NULL;
        assert_true(fabs(mean - 1) < 1e-3 && worst < (weighed ? 0.3 : 0.1));
        image_free(&image);
    }
    /* Matte surfaces are black here and one hit is all, before Russian roulette sets in: each sample is 1,
     * where the sky is seen or a mirror that shows it, or 0. So a pixel of four samples is a whole number of
     * quarters, to the last bits. */
    Image image = render("", "scenes/furnace.glsl --spp 4 --size 64x64 --depth 1 --set albedo=0");
    int bright = 0;
    for (int k = 0; k < 64 * 64; k++) {
        float quarters = 4 * image.rgba[4 * k];
        assert_true(quarters >= 0 && quarters < 4 + 4e-6f && fabsf(quarters - roundf(quarters)) < 4e-6f);
        bright += quarters > 3.5f;
    }
    print_message("furnace of black ground: %d of %d pixels white\n", bright, 64 * 64);
    /* The sky alone is a quarter of the picture; the mirror shows more of it. */
    assert_true(bright > 64 * 64 / 4 + 50);
    image_free(&image);
}

/* Mirrors of albedo 1 on all sides but one lose nothing: each pixel is 1 but for what roulette does to the
 * few long paths. */
static void test_mirror_room(void **state) {
    (void)state;
    const char *scene = support_write(
        "mirrors.glsl",
        "//@ camera eye 0 0.5 0 target 0 0.4 1 fov 100\n#include \"material/mirror.glsl\"\n#include "
        "\"shape/plane.glsl\"\n"
        "#include \"shape/sphere.glsl\"\nvoid scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
        "    hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit);\n"
        "    for (int i = 0; i < 12; i++)\n        hit_sphere(ray, vec3(float(i % 4) - 1.5, 0.45, 1.0 + "
        "float(i / 4)), 0.49, 0, hit);\n}\n"
        "Material scene_material(Hit hit) { return mirror(vec3(1)); }\n");
    static const char *const methods[] = {"cosine", "control", "mis"};
    for (int i = 0; i < 3; i++) {
        char arguments[512];
        double mean = 0;
        snprintf(arguments, sizeof arguments, "'%s' --sky uniform --size 64x64 --spp 256 --light %s", scene,
                 methods[i]);
        Image image = render("", arguments);
        for (int k = 0; k < 64 * 64; k++) mean += (double)image.rgba[4 * k] / (64 * 64);
        print_message("mirror room, %s: mean %.6f\n", methods[i], mean);
        assert_true(fabs(mean - 1) < 1e-3);
        image_free(&image);
    }
}

/* A bowl of half a sphere sees half of itself and half of the sky from each of its points. With albedo a
 * under a sky of 1 its radiance after N hits is the sum of (a/2)^n, n = 1 to N; and the plane's is a. */
static void test_bowl(void **state) {
    (void)state;
    static const int depths[] = {1, 2, 3, 0};
    for (int i = 0; i < 4; i++) {
        char arguments[512];
        double a = 0.8, expected = 0, bowl = 0;
        snprintf(arguments, sizeof arguments,
                 "scenes/crater.glsl --sky uniform --set ball=0 --set even_albedo=0.8 --set odd_albedo=0.8 "
                 "--size 64x64 --spp 256 --depth %d --set camera.eye=0,2,0 --set camera.target=0,0,0 --set "
                 "camera.fov=30",
                 depths[i]);
        for (int n = 1; n <= (depths[i] ? depths[i] : 60); n++) expected += pow(a / 2, n);
        Image image = render("", arguments);
        for (int k = 0; k < 64 * 64; k++) bowl += (double)image.rgba[4 * k] / (64 * 64);
        if (fabs(bowl - expected) > 1e-3)
            fail_msg("depth %d: %.5f, expected %.5f", depths[i], bowl, expected);
        image_free(&image);
    }
    Image plane = render(
        "",
        "scenes/crater.glsl --sky uniform:2 --set even_albedo=0.8 --set odd_albedo=0.8 --size 8x8 --spp 4 "
        "--set camera.eye=50,2,0 --set camera.target=50,0,0 --set ball=0 --set camera.fov=10");
    for (int k = 0; k < 64; k++) assert_true(fabsf(plane.rgba[4 * k] - 1.6f) < 1e-5f);
    image_free(&plane);
}

static const char small[] = "scenes/crater.glsl --size 96x80 --spp 40 --sky paper:8x2";

static void test_backends_agree(void **state) {
    (void)state;
    static const char *const others[] = {"osmesa", "glfw"};
    Context context;
    Error error;
    char renderer[2][384], arguments[256];
    int compared = 0;
    if (!context_open(&context, "egl", &error)) support_no_gl(error.text);
    snprintf(renderer[0], sizeof renderer[0], "%s %s", context.renderer, context.version);
    context_close(&context);
    for (int i = 0; i < 2; i++) {
        if (!context_open(&context, others[i], &error)) {
            print_message("not compared: %s\n", error.text);
            continue;
        }
        snprintf(renderer[1], sizeof renderer[1], "%s %s", context.renderer, context.version);
        context_close(&context);
        if (strcmp(renderer[0], renderer[1]) != 0) {
            print_message("not compared: %s is '%s', egl is '%s'\n", others[i], renderer[1], renderer[0]);
            continue;
        }
        char first[256];
        snprintf(first, sizeof first, "%s --backend egl", small);
        snprintf(arguments, sizeof arguments, "%s --backend %s", small, others[i]);
        expect_equal("", first, "", arguments);
        compared++;
    }
    if (!compared) skip();
}

/* Mesa's other software driver shares no code generator with llvmpipe: a second opinion on the shader, on a
 * tiny picture. */
static void test_second_driver(void **state) {
    (void)state;
    static const char *const lights[] = {"cosine", "control"};
    support_run("GALLIUM_DRIVER=softpipe", "info");
    if (!strstr(support_out, "softpipe")) {
        print_message("no softpipe here\n");
        skip();
    }
    for (int i = 0; i < 2; i++) {
        char arguments[256];
        snprintf(arguments, sizeof arguments,
                 "scenes/crater.glsl --size 24x24 --spp 16 --sky table --light %s", lights[i]);
        Image a = render("GALLIUM_DRIVER=softpipe", arguments), b = render("", arguments);
        Comparison c = compare(&a, &b);
        print_message("softpipe against the default driver, %s: relRMSE %.2e %%\n", lights[i],
                      c.rel_rmse_percent);
        assert_true(c.rel_rmse_percent < 0.1);
        image_free(&a);
        image_free(&b);
    }
}

static void test_threads_agree(void **state) {
    (void)state;
    expect_equal("LP_NUM_THREADS=1", small, "LP_NUM_THREADS=2", small);
}

static void test_seeds(void **state) {
    (void)state;
    expect_equal("", "scenes/crater.glsl --size 32x32 --spp 8 --seed 3", "",
                 "scenes/crater.glsl --size 32x32 --spp 8 --seed 3");
    Image a = render("", "scenes/crater.glsl --size 32x32 --spp 8 --seed 3");
    Image b = render("", "scenes/crater.glsl --size 32x32 --spp 8 --seed 4");
    assert_true(compare(&a, &b).rel_rmse_percent > 1);
    image_free(&a);
    image_free(&b);
}

static bool yes(void) {
    return true;
}

/* A picture of a group of samples, drawn at this pace; 0 for one that is not known yet. */
static Image picture_at(Renderer *renderer, double seconds, Pace *pace) {
    Image image = {0};
    FilmCount count;
    Error error;
    film_reset(&renderer->film);
    renderer->pace = (Pace){0};
    if (seconds > 0) pace_set(&renderer->pace, renderer->film.width, renderer->film.height, seconds);
    assert_true(renderer_pass(renderer, 16, NULL, &error) &&
                film_read(&renderer->film, &image, &count, &error));
    assert_true(count.accepted ==
                renderer->film.samples * (uint64_t)renderer->film.width * (uint64_t)renderer->film.height);
    *pace = renderer->pace;
    return image;
}

/* Pieces of a row, whole pictures, and blocks that are timed before the first piece: the picture is the same
 * to the bit, with the sun's own image in it. */
static void test_pieces_agree(void **state) {
    (void)state;
    enum { WIDTH = 320, HEIGHT = 210 };
    Context context;
    Renderer renderer;
    Scene scene;
    Error error;
    Pace pace;
    size_t size = 4 * WIDTH * HEIGHT * sizeof(float);
    support_open(&context);
    assert_true(scene_read(&scene, "scenes/crater.glsl", "glsl", &error));
    scene.values.sun.elevation_deg = 5;
    RenderParams params = {.scene = &scene, .sun_disk = "sampled", .width = WIDTH, .height = HEIGHT};
    if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    Image whole = picture_at(&renderer, 1e-12, &pace);
    assert_int_equal(pace.draws, 1);
    Image rows = picture_at(&renderer, 1, &pace);
    print_message("%ld draws, the longest %.3f s\n", pace.draws, pace.longest_s);
    assert_true(pace.draws > 5);
    Image probed = picture_at(&renderer, 0, &pace);
    assert_true(pace.draws > 1 && pace.width == WIDTH && pace.mean[PACE_BANDS / 2] > 0);
    assert_memory_equal(whole.rgba, rows.rgba, size);
    assert_memory_equal(whole.rgba, probed.rgba, size);
    image_free(&whole);
    image_free(&rows);
    image_free(&probed);
    renderer_destroy(&renderer);
    scene_destroy(&scene);
    context_close(&context);
}

/* However the work is cut into passes and strips, stopped and taken up again, the mean is the same to the
 * bit. */
static void test_cuts_agree(void **state) {
    (void)state;
    Context context;
    Renderer renderer;
    Scene scene;
    Error error;
    Image whole, cut;
    FilmCount count;
    support_open(&context);
    assert_true(scene_read(&scene, "scenes/crater.glsl", "glsl", &error));
    RenderParams params = {.scene = &scene, .sky = "paper:8x2", .width = 48, .height = 40};
    if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    assert_int_equal(renderer.plan.group_samples, 16);
    while (renderer.film.samples < 40) {
        assert_true(renderer_pass(&renderer, 40 - renderer.film.samples, NULL, &error));
    }
    assert_true(film_read(&renderer.film, &whole, &count, &error));
    film_reset(&renderer.film);
    for (int i = 0; renderer.film.samples < 40; i++) {
        renderer.pixels_per_second = i % 2 ? 1 : 10000;
        pace_set(&renderer.pace, 48, 40, i % 2 ? 1 : 1e-5);
        /* Each group after the first is once begun and dropped. */
        if (renderer.film.samples) {
            uint64_t before = renderer.film.samples;
            assert_true(renderer_pass(&renderer, 40 - before, yes, &error));
            assert_true(renderer.film.samples == before);
        }
        assert_true(renderer_pass(&renderer, 40 - renderer.film.samples, NULL, &error));
    }
    assert_true(film_read(&renderer.film, &cut, &count, &error));
    assert_memory_equal(whole.rgba, cut.rgba, 4 * 48 * 40 * sizeof(float));
    assert_true(count.accepted == 40 * 48 * 40 && count.rejected == 0);
    image_free(&cut);

    /* Stopped in the first group, it keeps the rows that it came to. */
    film_reset(&renderer.film);
    renderer.pixels_per_second = 1;
    pace_set(&renderer.pace, 48, 40, 1);
    assert_true(renderer_pass(&renderer, 16, yes, &error));
    assert_true(film_read(&renderer.film, &cut, &count, &error));
    assert_true(count.accepted == 16 * 48 && cut.rgba[3] == 1 && cut.rgba[4 * 48 * 39 + 3] == 0);
    image_free(&cut);
    image_free(&whole);
    renderer_destroy(&renderer);
    scene_destroy(&scene);
    context_close(&context);
}

/* Looks along +z at a sun of azimuth 0. */
#define SUNWARD                                                                                              \
    "//@ camera eye 0 1 0 target 0 1 1\n#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"   \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit); }\n"

static RenderParams read_sunward(Scene *scene, const char *path, double azimuth_deg) {
    Error error;
    if (!scene_read(scene, path, "glsl", &error)) fail_msg("%s", error.text);
    scene_set_sun(scene, 5, azimuth_deg);
    return (RenderParams){.scene = scene, .sky = "uniform", .sun_disk = "sampled", .width = 48, .height = 32};
}

static Image take_picture(Renderer *renderer) {
    Image image = {0};
    FilmCount count;
    Error error;
    if (!renderer_pass(renderer, 16, NULL, &error) || !film_read(&renderer->film, &image, &count, &error))
        fail_msg("%s", error.text);
    return image;
}

/* The sun comes into the picture after a file was broken: the program for its image is of the text of before.
 */
static void test_image_of_broken_scene(void **state) {
    (void)state;
    Context context;
    Renderer renderer, other;
    Scene scene;
    Error error;
    support_open(&context);
    support_write("tint.glsl", "vec3 tint() { return vec3(0.5); }\n");
    const char *path =
        support_write("sunward.glsl", SUNWARD "#include \"tint.glsl\"\n"
                                              "Material scene_material(Hit hit) { return matte(tint()); }\n");
    RenderParams params = read_sunward(&scene, path, 0);
    if (!renderer_create(&other, &context, &params, &error)) fail_msg("%s", error.text);
    assert_true(other.image.where.count > 0);
    Image expected = take_picture(&other);
    scene_set_sun(&scene, scene.values.sun.elevation_deg, 180);
    if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    assert_int_equal(renderer.image.where.count, 0);
    scene_set_sun(&scene, scene.values.sun.elevation_deg, 0);
    support_write("tint.glsl", "vec3 tint() { return vec3(0.5, ); }\n");
    if (!renderer_restart(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    Image image = take_picture(&renderer);
    assert_memory_equal(image.rgba, expected.rgba, 4 * 48 * 32 * sizeof(float));
    image_free(&image);
    image_free(&expected);
    renderer_destroy(&other);
    renderer_destroy(&renderer);
    scene_destroy(&scene);
    context_close(&context);
}

/* Where only the program for the sun's image does not compile, the picture without it stays. */
static void test_refused_restart(void **state) {
    (void)state;
    Context context;
    Renderer renderer;
    Scene scene;
    Error error;
    support_open(&context);
    const char *path = support_write("clash.glsl", SUNWARD
                                     "vec3 sun_image_direct(vec2 pixel, vec2 u) { return vec3(0.0); }\n"
                                     "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n");
    RenderParams params = read_sunward(&scene, path, 180);
    if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    Image expected = take_picture(&renderer);
    scene_set_sun(&scene, scene.values.sun.elevation_deg, 0);
    params.width = 40;
    assert_false(renderer_restart(&renderer, &context, &params, &error));
    assert_int_equal(error.status, STATUS_SCENE);
    assert_true(renderer.film.samples == 16 && renderer.film.width == 48);
    film_reset(&renderer.film);
    Image image = take_picture(&renderer);
    assert_memory_equal(image.rgba, expected.rgba, 4 * 48 * 32 * sizeof(float));
    image_free(&image);
    image_free(&expected);
    renderer_destroy(&renderer);
    scene_destroy(&scene);
    context_close(&context);
}

/* Samples that are not finite are left out, counted and told. */
static void test_nonfinite(void **state) {
    (void)state;
    const char *scene = support_write(
        "nan.glsl",
        "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit); }\n"
        "Material scene_material(Hit hit) {\n"
        "    float zero = hit.position.x * 0.0;\n"
        "    return matte(hit.position.x > 0.0 ? vec3(zero / zero) : vec3(0.5)); }\n");
    Image image;
    Error error;
    support_expect(0, "samples were not finite, or too large to be summed, and are left out",
                   "render '%s' --sky uniform --size 32x32 --spp 4 --progress json -o '%s'", scene,
                   support_path("nan.pfm"));
    assert_non_null(strstr(support_err, "\"rejected\": "));
    assert_null(strstr(support_err, "\"rejected\": 0,"));
    assert_true(image_read(&image, support_path("nan.pfm"), &error));
    for (int k = 0; k < 4 * 32 * 32; k++) assert_true(isfinite(image.rgba[k]));
    /* Below the horizon on the picture's left (+x) every sample is lost, on its right none is. */
    assert_true(image.rgba[4 * (31 * 32)] == 0 && image.rgba[4 * (31 * 32 + 31)] == 0.5f);
    image_free(&image);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_references),
        cmocka_unit_test(test_sunlit_reference),
        cmocka_unit_test(test_table_in_picture),
        cmocka_unit_test(test_furnace),
        cmocka_unit_test(test_mirror_room),
        cmocka_unit_test(test_bowl),
        cmocka_unit_test(test_seeds),
        cmocka_unit_test(test_threads_agree),
        cmocka_unit_test(test_second_driver),
        cmocka_unit_test(test_backends_agree),
        cmocka_unit_test(test_cuts_agree),
        cmocka_unit_test(test_pieces_agree),
        cmocka_unit_test(test_image_of_broken_scene),
        cmocka_unit_test(test_refused_restart),
        cmocka_unit_test(test_nonfinite),
    };
    return cmocka_run_group_tests_name("picture", tests, support_folder, support_clean);
}
