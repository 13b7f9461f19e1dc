/* A scene's texts: each file is read once, by whatever name it is included, and names that would clash are
 * refused. */
#include "support.h"

#include "render/aov.h"
#include "render/renderer.h"
#include "source/glsl_scan.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define BALL                                                                                                 \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"                                                      \
    "    hit_sphere(ray, vec3(0.0), 1.0, 0, hit);\n"                                                         \
    "}\n"

/* Whether the text has `part`, and once only. */
static bool has_once(const char *text, const char *part) {
    const char *first = strstr(text, part);
    return first && !strstr(first + 1, part);
}

static void make_folder(const char *name) {
    assert_true(mkdir(support_path(name), 0777) == 0 || access(support_path(name), F_OK) == 0);
}

static void expect_refused(const char *name, const char *text, const char *part) {
    Scene scene;
    Error error;
    if (scene_read(&scene, support_write(name, text), "glsl", &error)) fail_msg("%s: not refused", text);
    assert_int_equal(error.status, STATUS_SCENE);
    if (!strstr(error.text, part)) fail_msg("%s\nin place of %s", error.text, part);
}

static void test_spellings(void **state) {
    (void)state;
    GlslSource source;
    Error error;
    make_folder("sub");
    support_write("a.glsl", "float k() { return 1.0; }\n");
    support_write("sub/b.glsl",
                  "#include \"../a.glsl\"\n#include \"../sub/../a.glsl\"\nfloat b() { return k(); }\n");
    unlink(support_path("link.glsl"));
    assert_int_equal(symlink("a.glsl", support_path("link.glsl")), 0);
    const char *path = support_write("spellings.glsl", "#include \"a.glsl\"\n#include \"./a.glsl\"\n"
                                                       "#include \".//a.glsl\"\n#include \"link.glsl\"\n"
                                                       "#include \"sub/b.glsl\"\n");
    if (!support_flatten(&source, "glsl", path, NULL, &error)) fail_msg("%s", error.text);
    assert_true(has_once(text_string(&source.text), "float k()"));
    assert_int_equal(source.file_count, 3);
    glsl_source_destroy(&source);
}

/* Files of the user's that only share the last part of their names are others. */
static void test_same_names(void **state) {
    (void)state;
    GlslSource source;
    Error error;
    make_folder("one");
    make_folder("two");
    support_write("one/util.glsl", "float one() { return 1.0; }\n");
    support_write("two/util.glsl", "float two() { return 2.0; }\n");
    support_write("one/use.glsl", "#include \"util.glsl\"\n");
    support_write("two/use.glsl", "#include \"util.glsl\"\n");
    const char *path = support_write("names.glsl", "#include \"one/use.glsl\"\n#include \"two/use.glsl\"\n");
    if (!support_flatten(&source, "glsl", path, NULL, &error)) fail_msg("%s", error.text);
    assert_non_null(strstr(text_string(&source.text), "float one()"));
    assert_non_null(strstr(text_string(&source.text), "float two()"));
    glsl_source_destroy(&source);
}

/* The user's file of a library file's name takes its place in the library too, and the other way round the
 * library's files keep to each other. */
static void test_own_material(void **state) {
    (void)state;
    char command[600];
    make_folder("material");
    snprintf(command, sizeof command, "cp glsl/material/mirror.glsl '%s'",
             support_path("material/mirror.glsl"));
    assert_int_equal(system(command), 0);
    const char *path = support_write("own-mirror.glsl", "//@ sun elevation 30\n//@ mirror-sphere 0 0 0 1\n"
                                                        "#include \"material/mirror.glsl\"\n"
                                                        "#include \"shape/sphere.glsl\"\n" BALL
                                                        "Material scene_material(Hit hit) {\n"
                                                        "    return mirror(vec3(0.9));\n}\n");
    support_expect(0, "", "render '%s' --sun-disk --size 8x8 --spp 1 --quiet -o '%s'", path,
                   support_path("own-mirror.pfm"));
    support_expect(0, "", "flatten '%s' --sun-disk", path);
    assert_true(has_once(support_out, "Material mirror("));
    unlink(support_path("material/mirror.glsl"));
}

static void test_left_out(void **state) {
    (void)state;
    GlslSource source;
    Error error;
    support_write("in.glsl", "float in_use() { return 1.0; }\n");
    const char *path =
        support_write("zero.glsl", "#if 0 // an older way\n"
                                   "#include \"nowhere.glsl\"\n"
                                   "#ifdef FROB\n#include \"nowhere.glsl\"\n#else\nfloat no() {}\n#endif\n"
                                   "uniform float old; //@ slider 7\n"
                                   "#else\n#include \"in.glsl\"\n#endif\n"
                                   "#if 1\n#include \"in.glsl\"\n#endif\n");
    if (!support_flatten(&source, "glsl", path, NULL, &error)) fail_msg("%s", error.text);
    assert_true(has_once(text_string(&source.text), "float in_use()"));
    assert_null(strstr(text_string(&source.text), "#include"));
    GlslScan scan = glsl_scan(text_string(&source.text));
    assert_true(glsl_scan_defines(&scan, "in_use") && !glsl_scan_defines(&scan, "no"));
    assert_false(glsl_scan_mentions(&scan, "old"));
    glsl_scan_free(&scan);
    glsl_source_destroy(&source);
    Scene scene;
    if (!scene_read(&scene, path, "glsl", &error)) fail_msg("%s", error.text);
    assert_int_equal(scene.file->parameter_count, 0);
    scene_destroy(&scene);
    expect_refused("zero.glsl", "#ifdef FROB\n#include \"nowhere.glsl\"\n#endif\n",
                   "zero.glsl:2: no file 'nowhere.glsl'");
}

static void test_refused_names(void **state) {
    (void)state;
    make_folder("material");
    support_write("material/my-metal.glsl", "");
    expect_refused("name.glsl", "\n#include \"material/my-metal.glsl\"\n",
                   "name.glsl:2: 'my-metal' is no name for a material's file");
    expect_refused("name.glsl", "\nuniform float exposure; //@ slider 0.5\n",
                   "name.glsl:2: uniform 'exposure': every scene has a setting of that name");
    expect_refused("name.glsl", "uniform float time; //@ slider 0.5\n",
                   "name.glsl:1: uniform 'time': every scene");
    expect_refused("name.glsl", "uniform float max_hits; //@ slider 0.5\n",
                   "name.glsl:1: uniform 'max_hits': the host has a uniform of that name (pass/");
    expect_refused("name.glsl", "uniform vec3 sun_direction; //@ color 0 1 0\n",
                   "name.glsl:1: uniform 'sun_direction': the host has a uniform");
}

/* Words that are for people are kept whole. */
static void test_long_words(void **state) {
    (void)state;
    Scene scene;
    Error error;
    char words[1000], text[5000];
    memset(words, 'w', sizeof words - 1);
    words[sizeof words - 1] = 0;
    snprintf(text, sizeof text, "//@ title %s\n//@ look %s\nuniform float a; //@ slider 0 unit %s label %s\n",
             words, words, words, words);
    if (!scene_read(&scene, support_write("long.glsl", text), "glsl", &error)) fail_msg("%s", error.text);
    assert_string_equal(scene.file->title, words);
    assert_string_equal(scene.file->look, words);
    assert_string_equal(scene.file->parameters[0].unit, words);
    assert_string_equal(scene.file->parameters[0].label, words);
    scene_destroy(&scene);
}

/* A picture with all its programs is made of the texts that were read with the scene: what has become of the
 * files since is no matter. */
static void test_read_once(void **state) {
    (void)state;
    Context context;
    Renderer renderer;
    Aov aov;
    Scene scene;
    Error error;
    support_open(&context);
    support_write("rows.csv", "0,0,0,0.5\n");
    support_write("colour.glsl", "vec3 colour() { return vec3(0.5); }\n");
    const char *path = support_write(
        "once.glsl", "//@ spheres rows.csv\n//@ mirror-sphere 0 0 0 1\n#include \"colour.glsl\"\n"
                     "#include \"material/mirror.glsl\"\n#include \"shape/spheres.glsl\"\n"
                     "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_spheres(ray, 0, hit); }\n"
                     "Material scene_material(Hit hit) { return mirror(colour()); }\n");
    if (!scene_read(&scene, path, "glsl", &error)) fail_msg("%s", error.text);
    support_write("once.glsl", "broken");
    support_write("colour.glsl", "broken");
    support_write("rows.csv", "broken");
    RenderParams params = {.scene = &scene, .sun_disk = "auto", .width = 8, .height = 8};
    if (!renderer_create(&renderer, &context, &params, &error) ||
        !aov_create(&aov, AOV_ALBEDO, &context, &params, &renderer, &error)) {
        fail_msg("%s", error.text);
    }
    const SourceStore *sources = scene.file->sources;
    for (int i = 0; i < sources->file_count; i++) {
        for (int k = 0; k < i; k++) {
            const SourceFile *a = sources->files[i], *b = sources->files[k];
            if (a->device == b->device && a->node == b->node) fail_msg("%s is there twice", a->path);
        }
    }
    aov_destroy(&aov);
    renderer_destroy(&renderer);
    scene_destroy(&scene);
    context_close(&context);
}

static int clean(void **state) {
    char command[600];
    snprintf(command, sizeof command, "cd '%s' && rm -rf sub one two material", support_path("."));
    return system(command) == 0 ? support_clean(state) : -1;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_spellings),     cmocka_unit_test(test_same_names),
        cmocka_unit_test(test_own_material),  cmocka_unit_test(test_left_out),
        cmocka_unit_test(test_refused_names), cmocka_unit_test(test_long_words),
        cmocka_unit_test(test_read_once),
    };
    return cmocka_run_group_tests_name("sources", tests, support_folder, clean);
}
