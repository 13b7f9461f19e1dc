/* The passes of a picture as data: uniforms that both sides know, tables that are filled when they have to
 * be, and the list of programs. */
#include "support.h"

#include "gl/program.h"
#include "render/renderer.h"
#include "sky/irradiance.h"
#include "sky/sky_sampler.h"
#include "source/glsl_uniforms.h"

#include <string.h>

/* The source of a program of one file, which the library's `pass/` folder holds if `own` is false. */
static GlslSource source_of(const char *name, const char *glsl) {
    GlslSource source;
    Error error;
    if (!support_flatten(&source, "glsl", support_write(name, glsl), NULL, &error))
        fail_msg("%s", error.text);
    return source;
}

static void test_declarations(void **state) {
    (void)state;
    GlslSource source =
        source_of("declared.glsl", "#version 330 core\n"
                                   "// uniform float not_this;\n"
                                   "uniform vec3 a, b; /* uniform int nor_this; */ uniform float list[4];\n"
                                   "#include \"pass/sun.glsl\"\n"
                                   "uniform sampler2D last;\n"
                                   "float uniformly = 1.0;\nvoid main() { }\n");
    static const char *const names[] = {"a", "b", "list", "sun_direction", "sun_level", "last"};
    GlslUniforms declared = glsl_uniforms(text_string(&source.text));
    assert_int_equal(declared.count, 6);
    for (int i = 0; i < 6; i++) assert_string_equal(declared.items[i].name, names[i]);
    assert_string_equal(declared.items[5].type, "sampler2D");
    assert_int_equal(declared.items[0].file, 0);
    assert_int_equal(declared.items[3].file, 1);
    assert_int_equal(declared.items[5].file, 0);
    assert_null(glsl_uniforms_find(&declared, "not_this"));
    glsl_uniforms_free(&declared);
    glsl_source_destroy(&source);
}

/* A name that the host sets and the text does not declare is found, and so is one that it declares and nobody
 * sets. */
static void test_disagreement(void **state) {
    (void)state;
    static const double up[3] = {0, 1, 0};
    Context context;
    Program program;
    Uniforms uniforms = {0};
    Error error;
    support_open(&context);
    GlslSource source = source_of(
        "agree.glsl", "#version 330 core\n#include \"pass/sun.glsl\"\nuniform float mine;\nout vec4 color;\n"
                      "void main() { color = vec4(sun_direction + sun_level, mine); }\n");
    assert_true(program_create(&program, &context.gl, &source, &error));
    program_use(&program);
    uniforms_declared_in(&uniforms, "pass/sun.glsl");
    uniforms_vec3(&uniforms, "sun_direction", up);
    program_set(&program, &uniforms);
    assert_false(program_check(&program, &error));
    assert_non_null(strstr(error.text, "does not set the uniform 'sun_level'"));
    uniforms_vec3(&uniforms, "sun_level", up);
    uniforms_declared_in(&uniforms, "pass/camera.glsl");
    uniforms_vec3(&uniforms, "camera_eye", up);
    program_set(&program, &uniforms);
    /* A file that the program is not made of is none of its business; the scene's own uniforms need not be
     * set. */
    if (!program_check(&program, &error)) fail_msg("%s", error.text);
    uniforms_declared_in(&uniforms, "pass/sun.glsl");
    uniforms_vec3(&uniforms, "sun_levle", up);
    program_set(&program, &uniforms);
    assert_false(program_check(&program, &error));
    assert_non_null(strstr(error.text, "sets the uniform 'sun_levle', which is not declared"));
    uniforms_free(&uniforms);
    program_destroy(&program);
    glsl_source_destroy(&source);
    context_close(&context);
}

static void restart(Renderer *renderer, const Context *context, const RenderParams *params) {
    Error error;
    if (!renderer_restart(renderer, context, params, &error)) fail_msg("%s", error.text);
}

static int fills(const Renderer *renderer, const ResourceKind *kind) {
    const Resource *table = resources_find(&renderer->tables, kind);
    return table ? table->fills : 0;
}

/* Each table is filled when what it depends on has changed, and at no other time. */
static void test_fills(void **state) {
    (void)state;
    Context context;
    Renderer renderer;
    Scene scene;
    Error error;
    support_open(&context);
    if (!scene_read(&scene, "scenes/crater.glsl", "glsl", &error)) fail_msg("%s", error.text);
    RenderParams params = {.scene = &scene,
                           .sky = "table:gauss:4@16x48",
                           .light = "control",
                           .sun_disk = "sampled",
                           .width = 16,
                           .height = 16};
    if (!renderer_create(&renderer, &context, &params, &error)) fail_msg("%s", error.text);
    assert_int_equal(fills(&renderer, &sky_table), 1);
    assert_int_equal(fills(&renderer, &sky_patches), 1);
    assert_int_equal(fills(&renderer, &sky_irradiance), 1);
    assert_int_equal(fills(&renderer, &sun_cover), 1);
    assert_null(resources_find(&renderer.tables, &sky_sampler));
    params.seed = 3;
    restart(&renderer, &context, &params);
    assert_int_equal(
        fills(&renderer, &sky_table) + fills(&renderer, &sky_irradiance) + fills(&renderer, &sun_cover), 3);
    /* The sky turns with the sun's azimuth, and the disk does not. */
    scene_set_sun(&scene, scene.values.sun.elevation_deg, scene.values.sun.azimuth_deg + 10);
    restart(&renderer, &context, &params);
    assert_int_equal(fills(&renderer, &sky_table), 1);
    assert_int_equal(fills(&renderer, &sky_irradiance), 1);
    assert_int_equal(fills(&renderer, &sun_table), 2);
    scene.values.camera.fov_deg += 1;
    restart(&renderer, &context, &params);
    assert_int_equal(fills(&renderer, &sun_table), 2);
    assert_int_equal(fills(&renderer, &sun_cover), 3);
    scene_set_sun(&scene, scene.values.sun.elevation_deg - 10, scene.values.sun.azimuth_deg);
    restart(&renderer, &context, &params);
    assert_int_equal(fills(&renderer, &sky_table), 2);
    assert_int_equal(fills(&renderer, &sky_patches), 2);
    assert_int_equal(fills(&renderer, &sky_irradiance), 2);
    renderer_destroy(&renderer);
    scene_destroy(&scene);
    context_close(&context);
}

/* Every program of a picture is listed behind what it reads, and its text is made, without any OpenGL. */
static void test_list(void **state) {
    (void)state;
    static const char *const names[] = {"the sky's table",
                                        "the sky's patches",
                                        "the sky's irradiance",
                                        "the sun's image",
                                        "trace",
                                        "layers",
                                        "check"};
    enum { NAMES = sizeof names / sizeof *names };
    Scene scene;
    Plan plan;
    Error error;
    if (!scene_read(&scene, "scenes/crater.glsl", "glsl", &error)) fail_msg("%s", error.text);
    RenderParams params = {.scene = &scene, .sky = "table", .light = "control", .sun_disk = "sampled"};
    if (!plan_make(&plan, &params, NULL, &error)) fail_msg("%s", error.text);
    PassList list = pass_list(&plan, &params);
    assert_int_equal(list.count, NAMES);
    for (int i = 0; i < NAMES; i++) {
        GlslSource source;
        assert_string_equal(list.passes[i].name, names[i]);
        if (!pass_text(&list.passes[i], &plan, &params, &source, &error)) fail_msg("%s", error.text);
        assert_non_null(strstr(text_string(&source.text), "void main() {"));
        glsl_source_destroy(&source);
    }
    scene_destroy(&scene);
}

/* The program prints them all, as text and as JSON lines. */
static void test_flatten(void **state) {
    (void)state;
    static const char choice[] =
        "flatten scenes/sky.glsl --atmosphere simmons2017 --sky gauss:4 --light cosine";
    assert_int_equal(support_run("", "%s --all", choice), 0);
    assert_non_null(strstr(support_out, "// ==== trace\n#version 330"));
    assert_int_equal(support_run("", "%s --json", choice), 0);
    assert_non_null(
        strstr(support_out, "{\"pass\": \"trace\", \"order\": 0, \"entry\": \"pass/trace.glsl\""));
    assert_non_null(strstr(support_out, "\"uniform\": \"sun_direction\", \"type\": \"vec3\", "
                                        "\"declared_in\": \"pass/sun.glsl\", \"values\": ["));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_declarations),
                                       cmocka_unit_test(test_disagreement), cmocka_unit_test(test_fills),
                                       cmocka_unit_test(test_list), cmocka_unit_test(test_flatten)};
    return cmocka_run_group_tests_name("passes", tests, support_folder, support_clean);
}
