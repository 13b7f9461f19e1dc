/* Pages, without a browser: the file, its data, its shaders, and the two tables that a page draws and a
 * render computes. tests/test_web.c opens pages in a browser. */
#include "support.h"

#include "base/file.h"
#include "export/es.h"
#include "export/page_frame.h"
#include "export/page_variant.h"
#include "gl/target.h"
#include "gl/texture.h"
#include "scene_list.h"
#include "sky/sun.h"
#include "sky/sun_disk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Larger pages would be a fault of their data, which holds each piece of a shader once. */
enum { MOST_BYTES = 160000 };

static const char *page_of(const char *words, Text *page) {
    const char *path = support_path("page.html");
    Error error;
    support_expect(0, "", "export %s -o %s", words, path);
    text_free(page);
    if (!file_read(path, STATUS_OUTPUT, page, &error)) fail_msg("%s", error.text);
    return text_string(page);
}

/* The data is between the script element's tags. */
static const char *data_of(const char *page) {
    const char *tag = strstr(page, "id=\"data\">\n");
    assert_non_null(tag);
    return tag + strlen("id=\"data\">\n");
}

static void check_page(const char *path) {
    static const char *const outside[] = {
        "http:", "https:", "src=",    "href=",     "<link",        "@import",
        "url(",  "fetch(", "XMLHttp", "WebSocket", "importScripts"};
    Text text = {0};
    const char *page = page_of(path, &text);
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++)
        if (strstr(page, outside[i])) fail_msg("%s: the page has %s", path, outside[i]);
    const char *end = strstr(data_of(page), "</script>");
    assert_non_null(end);
    for (const char *c = data_of(page); c < end; c++)
        if (*c == '<') fail_msg("%s: the data has a tag", path);
    if (text.size > MOST_BYTES) fail_msg("%s: %zu bytes", path, text.size);
    print_message("%-28s %zu bytes\n", path, text.size);
    text_free(&text);
}

static void test_scenes(void **state) {
    (void)state;
    SceneList scenes = scene_list();
    for (int i = 0; i < scenes.count; i++) check_page(scenes.paths[i]);
}

/* The same page each time, and no OpenGL is needed. */
static void test_same(void **state) {
    (void)state;
    Text first = {0}, second = {0};
    page_of("scenes/crater.glsl", &first);
    assert_int_equal(support_run("LIBGL_DRIVERS_PATH=/nowhere GALLIUM_DRIVER=none DISPLAY=",
                                 "export %s -o %s", "scenes/crater.glsl", support_path("again.html")),
                     0);
    Error error;
    if (!file_read(support_path("again.html"), STATUS_OUTPUT, &second, &error)) fail_msg("%s", error.text);
    assert_int_equal(first.size, second.size);
    assert_memory_equal(first.data, second.data, first.size);
    text_free(&first);
    text_free(&second);
}

/* What a title or a label has in it is text. */
static void test_escapes(void **state) {
    (void)state;
    const char *scene = support_write(
        "tag.glsl",
        "//@ title </script><b>&\n#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
        "uniform float a; //@ slider 1 min 0 max 2 label \"<i>\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
        "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
        "Material scene_material(Hit hit) {\n    return matte(vec3(0.2 * a));\n}\n");
    Text text = {0};
    const char *page = page_of(scene, &text);
    assert_null(strstr(page, "<b>"));
    assert_null(strstr(page, "<i>"));
    assert_non_null(strstr(page, "<title>&#60;/script&#62;&#60;b&#62;&#38;</title>"));
    assert_non_null(strstr(page, "\\u003ci>"));
    text_free(&text);
}

static void test_refusals(void **state) {
    (void)state;
    const char *page = support_path("refused.html");
    support_expect(2, "where to? (-o FILE.html, once)", "export crater");
    support_expect(2, "--sequence metropolis: a page has no Markov chains",
                   "export crater --sequence metropolis -o %s", page);
    support_expect(2, "--sun-disk traced: a page traces no light paths",
                   "export crater --sun-disk=traced -o %s", page);
    support_expect(3, "air and mist", "export valley --set air=on --set mist=on -o %s", page);
    support_expect(5, "/nowhere/page.html", "export crater -o /nowhere/page.html");
    support_expect(3, "no-such-scene", "export no-such-scene -o %s", page);
    const char *toy =
        support_write("toy.glsl", "void mainImage(out vec4 c, vec2 p) { c = vec4(p, 0.0, 1.0); }\n");
    support_expect(2, "paints its picture by itself", "export %s -o %s", toy, page);
    const char *choice =
        support_write("choice.glsl", "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
                                     "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                                     "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                                     "Material scene_material(Hit hit) {\n"
                                     "    return hit.t > 1.0 ? matte(vec3(0.2)) : matte(vec3(0.5));\n}\n");
    support_expect(3, "choice.glsl:7", "export %s -o %s", choice, page);
    support_write("balls.csv", "0,1,0,1\n");
    const char *balls = support_write(
        "balls.glsl",
        "//@ spheres balls.csv\n#include \"material/matte.glsl\"\n#include \"shape/spheres.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n    hit_spheres(ray, 0, hit);\n}\n"
        "Material scene_material(Hit hit) {\n    return matte(vec3(0.2));\n}\n");
    support_expect(3, "balls.glsl:1: a page has no table of spheres, which is read from a file",
                   "export %s -o %s", balls, page);
    assert_int_not_equal(access(page, F_OK), 0);
}

/* ---- Shaders. */

static bool compiled(const Context *context, const char *text, Text *log) {
    const GlApi *gl = &context->gl;
    GLuint shader = gl->CreateShader(GL_FRAGMENT_SHADER);
    GLint good = 0;
    char words[2000] = "";
    gl->ShaderSource(shader, 1, &text, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    gl->GetShaderInfoLog(shader, sizeof words, NULL, words);
    text_print(log, "%s", words);
    gl->DeleteShader(shader);
    return good;
}

static Scene scene_of(const char *path, const char *preset) {
    Scene scene;
    Error error;
    if (!scene_read(&scene, path, "glsl", &error) || (preset && !scene_choose_preset(&scene, preset, &error)))
        fail_msg("%s", error.text);
    return scene;
}

/* Every shader of a picture is GLSL ES 3.00 for this machine's compiler too, and no comment is left. */
static void check_shaders(const Context *context, const char *path, const char *preset) {
    Scene scene = scene_of(path, preset);
    const RenderParams params = {.scene = &scene};
    Plan plan;
    Error error;
    if (!page_plan(&plan, &params, &error)) fail_msg("%s", error.text);
    PassList list = pass_list(&plan, &params);
    for (int i = 0; i < list.count; i++) {
        GlslSource source = {0};
        Text text = {0}, log = {0};
        if (list.passes[i].fills == NULL && strcmp(list.passes[i].name, "trace") != 0) continue;
        if (!pass_text(&list.passes[i], &plan, &params, &source, &error)) fail_msg("%s", error.text);
        if (!es_mend(&source, "glsl", &error)) fail_msg("%s", error.text);
        es_write(&source, &text);
        assert_null(strstr(text_string(&text), "//"));
        assert_null(strstr(text_string(&text), "#line"));
        if (!compiled(context, text_string(&text), &log))
            fail_msg("%s: %s: %s", path, list.passes[i].name, text_string(&log));
        glsl_source_destroy(&source);
        text_free(&text);
        text_free(&log);
    }
    scene_destroy(&scene);
}

static void test_shaders(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    const char *whole = support_write(
        "whole.glsl", "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
                      "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n    float level = 1;\n"
                      "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 2 * level, 0, hit);\n}\n"
                      "Material scene_material(Hit hit) {\n    return matte(vec3(1, 1, 0) / 2);\n}\n");
    check_shaders(&context, whole, NULL);
    check_shaders(&context, "scenes/crater.glsl", NULL);
    check_shaders(&context, "scenes/materials.glsl", NULL);
    check_shaders(&context, "scenes/sundial.glsl", NULL);
    check_shaders(&context, "scenes/valley.glsl", "fog");
    check_shaders(&context, "scenes/valley.glsl", "kilometres");
    context_close(&context);
}

/* Blanks between tokens are left out where they mean nothing, and only there. */
static void test_compact(void **state) {
    (void)state;
    GlslSource source = {0};
    Text text = {0};
    text_print(&source.text,
               "#version 330 core\n#line 1 1\n#define F(a) (a) // why\n  float x = a - -b + +c;\n"
               "/* so */ in  vec3 v ; // and\n#if 0\nnot this\n#endif\nF(x)  y = a / * b;\n");
    es_write(&source, &text);
    const char *begin = strstr(text_string(&text), "#define");
    assert_non_null(begin);
    assert_string_equal(
        begin, "#define F(a) (a)\nfloat x=a- -b+ +c;\nin vec3 v;\n#if 0\nnot this\n#endif\nF(x) y=a/ *b;\n");
    text_free(&text);
    text_free(&source.text);
}

/* ---- Uniforms. */

/* The value that a page takes at an elevation is the one that a render would set there. */
static void check_steps(const char *path, const char *preset) {
    static const double elevations[] = {-89.93, -20.3, -9.1, -7.6, -5.2, -3.38, -1.111,
                                        -0.02,  0.4,   3.19, 9.4,  14.7, 33.3,  71.9};
    Scene scene = scene_of(path, preset);
    RenderParams params = {.scene = &scene, .sky = "table:gauss:8"};
    Plan plan;
    Error error;
    if (!page_plan(&plan, &params, &error)) fail_msg("%s", error.text);
    PageScan scan = page_scan(&plan, &params, false);
    int stepping = 0;
    for (int i = 0; i < scan.frames[0].uniforms.count; i++) {
        double from[64];
        const PageFrame *frames[64];
        if (page_computes(&scan.frames[0].uniforms.items[i])) continue;
        int count = page_scan_steps(&scan, i, page_same_uniform, 64, from, frames);
        assert_true(count > 0);
        stepping += count > 1;
        for (size_t k = 0; k < sizeof elevations / sizeof *elevations; k++) {
            int at = count - 1;
            while (from[at] > elevations[k]) at--;
            PageFrame exact = page_frame_at(&scan, elevations[k]);
            if (!page_same_uniform(i, frames[at], &exact))
                fail_msg("%s: %s at %g degrees", path, exact.uniforms.items[i].name, elevations[k]);
            uniforms_free(&exact.uniforms);
        }
    }
    /* The size of the sky's table follows the sun. */
    assert_true(stepping > 0);
    page_scan_free(&scan);
    scene_destroy(&scene);
}

static void test_steps(void **state) {
    (void)state;
    check_steps("scenes/crater.glsl", NULL);
    check_steps("scenes/sundial.glsl", NULL);
    check_steps("scenes/valley.glsl", "fog");
}

/* ---- The sun's tables. */

/* Draws one of them with all uniforms of the frame. */
static float *drawn(const Context *context, const Scene *scene, const char *entry, int width, int height,
                    const float corner[2]) {
    RenderParams params = {.scene = scene, .sun_disk = "sampled", .width = 64, .height = 48};
    Plan plan;
    Error error;
    Program program;
    Target target;
    Uniforms uniforms = {0};
    const Pass pass = {.entry = entry};
    if (!page_plan(&plan, &params, &error) ||
        !pass_program(&program, &pass, &context->gl, &plan, &params, &error) ||
        !target_create(&target, context, width, height, 1, &error))
        fail_msg("%s", error.text);
    Camera camera = camera_of(scene, 64, 48);
    Frame frame = frame_of(&plan, &params, &camera);
    frame_uniforms(&frame, &plan, 0, &uniforms);
    sun_table.uniforms(NULL, &frame, &uniforms);
    if (corner) {
        double at[3] = {(double)corner[0], (double)corner[1], 0};
        uniforms_declared_in(&uniforms, entry);
        uniforms_vec3(&uniforms, "sun_image_corner", at);
    }
    program_use(&program);
    program_set(&program, &uniforms);
    SunDisk disk = sun_disk(&scene->values.atmosphere, &scene->values.sun);
    float table[4 * 256], *texels = calloc((size_t)(width * height), 4 * sizeof *texels);
    sun_disk_table(&disk, &scene->values.atmosphere, 256, table);
    GLuint texture = texture_create(&context->gl, 256, 1, GL_LINEAR, table);
    if (program_declares(&program, "sun_disk_table"))
        program_set_texture(&program, "sun_disk_table", texture);
    static const char *const names[] = {NULL};
    target_begin(&target, &program, names);
    program_draw(&program, 0, 0, width, height);
    target_swap(&target);
    if (!target_read(&target, 0, texels, &error)) fail_msg("%s", error.text);
    context->gl.DeleteTextures(1, &texture);
    program_destroy(&program);
    target_destroy(&target);
    uniforms_free(&uniforms);
    return texels;
}

/* The largest error of the table, as a part of its largest radiance. */
static double table_error(const Context *context, const char *atmosphere, double elevation_deg) {
    Scene scene = scene_of("scenes/crater.glsl", NULL);
    Error error;
    if (!atmosphere_choose(&scene.values.atmosphere, atmosphere, &error)) fail_msg("%s", error.text);
    scene_set_sun(&scene, elevation_deg, 0);
    float exact[4 * 256], *got = drawn(context, &scene, "pass/fill_sun.glsl", 256, 1, NULL);
    SunDisk disk = sun_disk(&scene.values.atmosphere, &scene.values.sun);
    sun_disk_table(&disk, &scene.values.atmosphere, 256, exact);
    double worst = 0, most = 0;
    for (int i = 0; i < 4 * 256; i++) {
        if (i % 4 == 3) continue;
        worst = fmax(worst, fabs((double)got[i] - (double)exact[i]));
        most = fmax(most, (double)exact[i]);
    }
    free(got);
    scene_destroy(&scene);
    assert_true(most > 0);
    print_message("%s, sun at %g: the table is within %.2g\n", atmosphere, elevation_deg, worst / most);
    return worst / most;
}

static void test_sun_table(void **state) {
    (void)state;
    static const double elevations[] = {60, 30, 5, 0.5, 0, -0.2};
    Context context;
    support_open(&context);
    for (size_t i = 0; i < sizeof elevations / sizeof *elevations; i++) {
        assert_true(table_error(&context, "simmons2017", elevations[i]) < 3e-5);
        assert_true(table_error(&context, "earth", elevations[i]) < 3e-5);
    }
    context_close(&context);
}

/* The light of the image, summed over its pixels, and the light of each that has a good part of it. */
static void check_cover(const Context *context, double elevation_deg, double fov_deg) {
    Scene scene = scene_of("scenes/crater.glsl", NULL);
    scene_set_sun(&scene, elevation_deg, 0);
    for (int i = 0; i < 3; i++)
        scene.values.camera.target[i] = scene.values.camera.eye[i] + scene.values.sun.direction[i];
    scene.values.camera.fov_deg = fov_deg;
    Camera camera = camera_of(&scene, 64, 48);
    SunDisk disk = sun_disk(&scene.values.atmosphere, &scene.values.sun);
    Rectangle r = camera_cone_rectangle(&camera, disk.middle, disk.radius);
    float corner[2] = {(float)r.x, (float)r.y},
          *got = drawn(context, &scene, "pass/fill_cover.glsl", r.width, r.height, corner);
    float *exact = calloc((size_t)(r.width * r.height), 4 * sizeof *exact);
    assert_true(sun_disk_cover(&disk, &scene.values.atmosphere, &camera, r, exact));
    double sums[2] = {0}, most = 0;
    for (int i = 0; i < 4 * r.width * r.height; i += 4) most = fmax(most, (double)exact[i]);
    for (int i = 0; i < 4 * r.width * r.height; i += 4) {
        sums[0] += (double)got[i];
        sums[1] += (double)exact[i];
        assert_true(fabs((double)got[i] - (double)exact[i]) < 0.01 * most);
    }
    print_message("sun at %g, %g degrees wide: its image has %.5f of its light\n", elevation_deg, fov_deg,
                  sums[0] / sums[1]);
    assert_true(fabs(sums[0] / sums[1] - 1) < 5e-3);
    free(got);
    free(exact);
    scene_destroy(&scene);
}

static void test_sun_cover(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    check_cover(&context, 30, 60);
    check_cover(&context, 5, 20);
    check_cover(&context, 0, 2);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes),   cmocka_unit_test(test_same),      cmocka_unit_test(test_escapes),
        cmocka_unit_test(test_refusals), cmocka_unit_test(test_shaders),   cmocka_unit_test(test_compact),
        cmocka_unit_test(test_steps),    cmocka_unit_test(test_sun_table), cmocka_unit_test(test_sun_cover)};
    return cmocka_run_group_tests_name("export", tests, support_folder, support_clean);
}
