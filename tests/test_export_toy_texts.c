/* What stands in the texts of `export --shadertoy`: settings, names, and the language of browsers. */
#include "support.h"
#include "tabs.h"

#include <stdio.h>

/* Values of the scene, of presets and of options, with their words. */
static void test_settings(void **state) {
    (void)state;
    const char *folder = support_path("settings");
    support_expect(0, "",
                   "export scenes/crater.glsl --shadertoy -o '%s' --preset sunset --set hover=1.25 --set "
                   "ball=off --seed 7 --depth 9",
                   folder);
    tabs_expect(folder, "common.glsl",
                "// height of the ball's centre, from -0.5 to 3 m.\nconst float hover = 1.25;\n");
    tabs_expect(folder, "common.glsl", "// mirror ball.\nconst bool ball = false;\n");
    tabs_expect(folder, "common.glsl", "const vec2 SUN = vec2(5.0, 0.0);\n");
    tabs_expect(folder, "common.glsl", "const float EXPOSURE_EV = 0.5;\n");
    tabs_expect(folder, "common.glsl", "const int MOST_HITS = 9;\nconst uint SEED = 7u;\n");
    tabs_expect(folder, "common.glsl", "normalize(vec3(0.0, 0.0, 0.0) - CAMERA_EYE)\n");
    tabs_expect(folder, "common.glsl", "--preset sunset --set hover=1.25");
    tabs_expect(folder, "buffer-a.glsl", "Set iChannel0 to Buffer A itself");
    tabs_expect(folder, "image.glsl", "const float gain = exp2(EXPOSURE_EV);");
    support_expect(0, "", "export scenes/mirrors.glsl --shadertoy -o '%s' --set tint=1,0.25,0.1 " TABS_HELD,
                   folder);
    tabs_expect(folder, "common.glsl", "const vec3 tint = vec3(1.0, 0.25, 0.1);\n");
    /* The six nodes of the sky are a table of six by six. */
    tabs_expect(folder, "common.glsl", "float[6](0.03376524,");
    tabs_expect(folder, "common.glsl", "float[36](");
}

#define GROUND                                                                                               \
    "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n#include \"shape/sphere.glsl\"\n"

/* Names that are the site's, or the other tabs', and words of GLSL ES. */
#define NAMES                                                                                                \
    "//@ title  has a \\ in it\n" GROUND                                                                     \
    "uniform float tone; //@ slider 0.5  min 0  max 1  label \"a \\\\\"\n"                                   \
    "uniform float sample = 0.25;\n"                                                                         \
    "const float EXPOSURE_EV = 0.5;\nfloat iDate = 1.0;\n"                                                   \
    "/* a comment\n   of two lines */\n"                                                                     \
    "float set_camera(float dither) { return dither * EXPOSURE_EV + 0.0 * iTime; }\n"                        \
    "void mainVR(INOUT(float) iChannel0) { iChannel0 *= 1.0; }\n"                                            \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"                                                      \
    "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"                                                \
    "    hit_sphere(ray, vec3(0.5 * iTime, 1.0, iMouse.x / iResolution.x), 1.0, 1, hit);\n}\n"               \
    "Material scene_material(Hit hit) {\n    float patch = set_camera(tone) * iDate;\n    mainVR(patch);\n"  \
    "    return matte(vec3(patch, sample, iFrame < 0 ? 1.0 : 0.5));\n}\n"

static void test_names(void **state) {
    (void)state;
    const char *scene = support_write("names.glsl", NAMES), *folder = support_path("names");
    support_expect(0, "", "export '%s' --shadertoy -o '%s' --set time=2", scene, folder);
    tabs_compile(folder);
    tabs_expect(folder, "common.glsl", "const float own_tone = 0.5;");
    tabs_expect(folder, "common.glsl", "const bool MOUSE_MOVES_SUN = false;");
    tabs_expect(folder, "common.glsl", "/* a comment\n   of two lines */\n");
    tabs_expect(folder, "common.glsl", "const float scene_iTime = 2.0;");
    tabs_expect(folder, "buffer-a.glsl", "    scene_iResolution = iResolution;\n");
    tabs_expect(folder, "buffer-a.glsl", "    scene_iFrame = iFrame;\n");
    tabs_need_gl();
    char path[700];
    snprintf(path, sizeof path, "'%s'", scene);
    assert_true(tabs_round_trip(path, "--set time=2 --set mouse=20,3,0,0", "40x30", 8) < 0.05);
}

/* What GLSL 3.30 has and browsers refuse. */
static void test_language(void **state) {
    (void)state;
    const char *folder = support_path("language");
    const char *choice = support_write(
        "choice.glsl", GROUND "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                              "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                              "Material scene_material(Hit hit) {\n    Material dark = matte(vec3(0.1));\n"
                              "    return hit.position.x > 0.0 ? dark : matte(vec3(0.9));\n}\n");
    support_expect(3, "choice.glsl:9: browsers refuse ?: between structures (Material)",
                   "export '%s' --shadertoy -o '%s'", choice, folder);
    const char *anew = support_write(
        "anew.glsl", GROUND "float round(float x) {\n    return floor(x + 0.5);\n}\n"
                            "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                            "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                            "Material scene_material(Hit hit) {\n    return matte(vec3(round(0.6)));\n}\n");
    support_expect(3, "anew.glsl:4: round() is a function of GLSL ES", "export '%s' --shadertoy -o '%s'",
                   anew, folder);
}

/* Whole numbers where floats are wanted, and where they are not. */
#define WHOLE                                                                                                \
    GROUND "const float size = 1;\nconst int COUNT = 3;\n"                                                   \
           "float twice(float x) {\n    float half_of = x / 2, rest = 0;\n    half_of = x * 1 - rest;\n"     \
           "    return 2 * half_of;\n}\n"                                                                    \
           "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"                                               \
           "    hit_plane(ray, vec3(0, 1, 0), 0, 0, hit);\n    for (int i = 0; i < COUNT; i++) {\n"          \
           "        int k = i * 2 + 1;\n        float n = -1;\n"                                             \
           "        hit_sphere(ray, vec3(float(k) - 3, 1 + size * 0, 0), 1 * size / 2, i + 1, hit);\n"       \
           "        if (n > 0 || k == 100) n = 2;\n    }\n}\n"                                               \
           "Material scene_material(Hit hit) {\n    vec3 p = hit.position;\n"                                \
           "    float q = pow(0.5, 2) + mix(0, 1, 0.5) + p.x * 0 + twice(0);\n"                              \
           "    return matte(vec3(0.2 * q, p.y > 1 ? 0.2 : 0.6, hit.object == 2 ? 0.1 : 0.5));\n}\n"

static void test_whole_numbers(void **state) {
    (void)state;
    const char *scene = support_write("whole.glsl", WHOLE), *folder = support_path("whole");
    support_expect(0, "", "export '%s' --shadertoy -o '%s'", scene, folder);
    tabs_compile(folder);
    tabs_expect(folder, "common.glsl", "const float size = 1.0;\nconst int COUNT = 3;\n");
    tabs_expect(folder, "common.glsl", "        int k = i * 2 + 1;\n        float n = -1.0;\n");
    tabs_expect(folder, "common.glsl", "1.0 * size / 2.0, i + 1, hit);");
    tabs_need_gl();
    char path[700];
    snprintf(path, sizeof path, "'%s'", scene);
    assert_true(tabs_round_trip(path, "", "40x30", 8) < 0.05);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_settings),
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_language),
        cmocka_unit_test(test_whole_numbers),
    };
    return cmocka_run_group_tests_name("texts of export --shadertoy", tests, support_folder, support_clean);
}
