/* Hints: annotated, or defined by the scene in GLSL. */
#include "support.h"

#include "render/renderer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 24 };

/* A mirror ball and a lamp over level ground, with whatever hints. The ball's size follows a slider. */
#define ROOM(hints)                                                                                          \
    "//@ camera eye 0 2 -5 target 0 1 0 fov 50\n//@ sun elevation 40 azimuth 150\n" hints                    \
    "#include \"material/emitter.glsl\"\n#include \"material/matte.glsl\"\n"                                 \
    "#include \"material/mirror.glsl\"\n#include \"shape/plane.glsl\"\n#include \"shape/sphere.glsl\"\n"     \
    "uniform float half_size; //@ slider 0.5 min 0.1 max 1\n"                                                \
    "uniform float size; //@ slider 1 min 0.1 max 2\n"                                                       \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"                                                      \
    "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"                                                \
    "    hit_sphere(ray, vec3(0.0, 1.0, 0.0), size, 1, hit);\n"                                              \
    "    hit_sphere(ray, vec3(1.5, 0.5, 0.0), 0.25, 2, hit);\n}\n"                                           \
    "Material scene_material(Hit hit) {\n"                                                                   \
    "    if (hit.object == 1) return mirror(vec3(0.9));\n"                                                   \
    "    if (hit.object == 2) return emitter(vec3(5.0));\n"                                                  \
    "    return matte(vec3(0.5));\n}\n"

static const char annotated[] = ROOM("//@ bound 0 1 0 size\n//@ mirror-sphere 0 1 0 size\n"
                                     "//@ emitter-sphere 1.5 0.5 0 0.25\n");
static const char defined[] =
    ROOM("") "const int SCENE_BOUNDS = 1;\nvec4 scene_bound(int i) { return vec4(0.0, 1.0, 0.0, 2.0 * "
             "half_size); }\n"
             "const int MIRROR_SPHERES = 1; // the ball\n"
             "vec4 mirror_sphere(int i) { return vec4(0.0, 1.0, 0.0, 2.0 * half_size); }\n"
             "const int EMITTER_SPHERES = 1;\n"
             "vec4 emitter_sphere(int i) { return vec4(1.5, 0.5, 0.0, 0.25); }\n";

static Image draw(const Context *context, const char *name, const char *text, const char *light,
                  double size) {
    Renderer renderer;
    Scene scene;
    Image image = {0};
    FilmCount count;
    Error error;
    char value[40];
    if (!scene_read(&scene, support_write(name, text), "glsl", &error)) fail_msg("%s", error.text);
    RenderParams params = {.scene = &scene,
                           .sky = "table:gauss:4@16x48",
                           .light = light,
                           .sun_disk = "sampled",
                           .width = SIDE,
                           .height = SIDE};
    if (!renderer_create(&renderer, context, &params, &error)) fail_msg("%s", error.text);
    snprintf(value, sizeof value, "%g", size);
    assert_true(scene_set(&scene, "size", value, &error));
    snprintf(value, sizeof value, "%g", size / 2);
    assert_true(scene_set(&scene, "half_size", value, &error));
    if (!renderer_restart(&renderer, context, &params, &error) ||
        !renderer_pass(&renderer, 8, NULL, &error) || !film_read(&renderer.film, &image, &count, &error)) {
        fail_msg("%s", error.text);
    }
    /* The sun itself is behind the camera, and its image in the ball before it. */
    assert_int_equal(renderer.image.where.count, 1);
    renderer_destroy(&renderer);
    scene_destroy(&scene);
    return image;
}

/* The same hints by annotations and in GLSL make the same picture to the bit, with the sun's image in the
 * mirror, which the host has to find, and after a slider has moved. */
static void test_in_glsl(void **state) {
    (void)state;
    static const char *const lights[] = {"control", "mis"};
    Context context;
    support_open(&context);
    for (int i = 0; i < 4; i++) {
        double size = i < 2 ? 1 : 0.75;
        Image a = draw(&context, "annotated.glsl", annotated, lights[i % 2], size);
        Image b = draw(&context, "defined.glsl", defined, lights[i % 2], size);
        float brightest = 0;
        for (int k = 0; k < 4 * SIDE * SIDE; k++) {
            if (a.rgba[k] > brightest) brightest = a.rgba[k];
        }
        /* The sun is in it: the lamp has 5. */
        assert_true(brightest > 20);
        assert_memory_equal(a.rgba, b.rgba, sizeof(float[4 * SIDE * SIDE]));
        image_free(&a);
        image_free(&b);
    }
    context_close(&context);
}

static void test_refused(void **state) {
    (void)state;
    static const struct {
        const char *text, *part;
    } cases[] = {
        {"\nvec4 mirror_sphere(int i) { return vec4(1.0); }\n",
         "hint.glsl:2: mirror_sphere() needs `const int MIRROR_SPHERES = NUMBER;`"},
        {"\n\nconst int MIRROR_PLANES = 2;\n", "hint.glsl:3: MIRROR_PLANES needs `vec2 mirror_plane(int i)`"},
        {"const int SCENE_BOUNDS = 2 + 1;\nvec4 scene_bound(int i) { return vec4(1.0); }\n",
         "hint.glsl:1: SCENE_BOUNDS is not a whole number in digits, from 0 to 16"},
        {"const int SCENE_BOUNDS = 17;\nvec4 scene_bound(int i) { return vec4(1.0); }\n",
         "hint.glsl:1: SCENE_BOUNDS is not a whole number in digits, from 0 to 16"},
        {"const int EMITTER_SPHERES = 1;\nvec4 emitter_sphere(int i) { return vec4(1.0); }\n"
         "//@ emitter-sphere 0 0 0 1\n",
         "hint.glsl:3: emitter-sphere: the scene defines emitter_sphere() itself"},
        {"//@ portal 0 1 0 90 0 2\n",
         "hint.glsl:1: portal needs x y z, the azimuth and the elevation that it faces, width and height"},
        {"//@ portal 0 1 0 90 0 2 0\n",
         "hint.glsl:1: portal: '0' is neither a number above 0 nor a slider's"},
        {"\n//@ portal 0 1 0 90 0 -wide 1\nuniform float wide; //@ slider 1\n",
         "hint.glsl:2: portal: '-wide' is neither a number above 0 nor a slider's name"},
        {"//@ portal 0 1 0 east 0 2 1\n", "hint.glsl:1: portal: 'east' is neither a number nor a slider's"},
        {"const int SCENE_PORTALS = 1;\n", "hint.glsl:1: SCENE_PORTALS needs `mat3 scene_portal(int i)`"},
        {"mat3 scene_portal(int i) { return mat3(1.0); }\n",
         "hint.glsl:1: scene_portal() needs `const int SCENE_PORTALS = NUMBER;`"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Scene scene;
        Error error;
        if (scene_read(&scene, support_write("hint.glsl", cases[i].text), "glsl", &error))
            fail_msg("%s: not refused", cases[i].text);
        assert_int_equal(error.status, STATUS_SCENE);
        if (!strstr(error.text, cases[i].part)) fail_msg("%s\nin place of %s", error.text, cases[i].part);
    }
}

static const char *light_of(const char *text, char *light, size_t size) {
    Scene scene;
    Plan plan;
    Error error;
    if (!scene_read(&scene, support_write("words.glsl", text), "glsl", &error)) fail_msg("%s", error.text);
    RenderParams params = {.scene = &scene, .samples = 64};
    if (!plan_make(&plan, &params, NULL, &error)) fail_msg("%s", error.text);
    snprintf(light, size, "%s", plan.light.text);
    scene_destroy(&scene);
    return light;
}

#define LOW_BALL(bound, mirror)                                                                              \
    "//@ sun elevation 5\n//@ bound " bound "\n//@ mirror-sphere " mirror "\n"                               \
    "#include \"material/mirror.glsl\"\n#include \"shape/sphere.glsl\"\n"                                    \
    "uniform float r; //@ slider 1\n"                                                                        \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_sphere(ray, vec3(0.0), 1.0, 0, hit); }\n"           \
    "Material scene_material(Hit hit) { return mirror(vec3(0.9)); }\n"

/* A bound and a mirror are one thing by their numbers and sliders, however these are written: where nothing
 * else may block the sky, auto takes another light. */
static void test_words(void **state) {
    (void)state;
    char same[64], other[64];
    light_of(LOW_BALL("0 0.5 0 r", "0 0.5 0 r"), same, sizeof same);
    light_of(LOW_BALL("0 0.5 0 r", "0 0.75 0 r"), other, sizeof other);
    assert_string_not_equal(same, other);
    assert_string_equal(light_of(LOW_BALL("0 0.50 -0 r", "0.0 5e-1 0 r"), other, sizeof other), same);
    light_of(LOW_BALL("0 0.5 0 1", "0 0.5 0 r"), other, sizeof other);
    assert_string_not_equal(same, other);
}

#define LIT_ROOM(eye, portal)                                                                                \
    "//@ camera eye " eye " target 0 1 0\n" portal "#include \"material/matte.glsl\"\n"                      \
    "#include \"shape/plane.glsl\"\nuniform float wide; //@ slider 1\n"                                      \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit); }\n"  \
    "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n"

/* auto looks through portals if the camera stands where one of them faces. */
static void test_room(void **state) {
    (void)state;
    static const char glsl[] =
        "const int SCENE_PORTALS = 1;\nmat3 scene_portal(int i) { return mat3(1.0); }\n";
    char light[64], text[2048];
    assert_string_equal(light_of(LIT_ROOM("0 1 -2", ""), light, sizeof light), "cosine");
    assert_string_equal(light_of(LIT_ROOM("0 1 -2", "//@ portal -2 1 0 90 0 wide 1\n"), light, sizeof light),
                        "portal");
    assert_string_equal(light_of(LIT_ROOM("-3 1 -2", "//@ portal -2 1 0 90 0 wide 1\n"), light, sizeof light),
                        "cosine");
    assert_string_equal(light_of(LIT_ROOM("-3 1 -2", "//@ portal -2 1 0 90 0 wide 1\n"
                                                     "//@ portal 0 3 0 15 -90 wide 1\n"),
                                 light, sizeof light),
                        "portal");
    assert_string_equal(light_of(LIT_ROOM("0 4 -2", "//@ portal 0 3 0 15 -90 wide 1\n"), light, sizeof light),
                        "cosine");
    snprintf(text, sizeof text, "%s%s", LIT_ROOM("-3 1 -2", ""), glsl);
    assert_string_equal(light_of(text, light, sizeof light), "portal");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_in_glsl),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_words),
        cmocka_unit_test(test_room),
    };
    return cmocka_run_group_tests_name("hints", tests, support_folder, support_clean);
}
