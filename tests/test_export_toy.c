/* `export --shadertoy`: the texts as the site takes them, and the pictures that they draw when they are given
 * back to `render`. The site itself is not asked: glslangValidator reads the texts with what the site writes
 * around them. */
#include "scene_list.h"
#include "support.h"

#include "base/file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* What the texts can hold of all scenes. */
#define HELD "--orders 1 --set atmosphere.ground_albedo=0 --sun-disk=off"

static void need_gl(void) {
    Context context;
    support_open(&context);
    context_close(&context);
}

static Text read_text(const char *path) {
    Text text = {0};
    Error error;
    if (!file_read(path, STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    return text;
}

static Text read_tab(const char *folder, const char *tab) {
    char path[600];
    snprintf(path, sizeof path, "%s/%s", folder, tab);
    return read_text(path);
}

/* Fails unless the file of the folder has the words. */
static void expect_words(const char *folder, const char *tab, const char *words) {
    Text text = read_tab(folder, tab);
    if (!strstr(text_string(&text), words)) fail_msg("%s/%s: no '%s'", folder, tab, words);
    text_free(&text);
}

static const char es_head[] = "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                              "precision highp sampler2D;\n";
static const char tab_head[] = "#define HW_PERFORMANCE 1\nuniform vec3 iResolution;\nuniform float "
                               "iTime;\nuniform float iChannelTime[4];\n"
                               "uniform vec4 iMouse;\nuniform vec4 iDate;\nuniform float "
                               "iSampleRate;\nuniform vec3 iChannelResolution[4];\n"
                               "uniform int iFrame;\nuniform float iTimeDelta;\nuniform float "
                               "iFrameRate;\nuniform sampler2D iChannel0;\n"
                               "void mainImage(out vec4 c, in vec2 f);\n";
static const char tab_tail[] =
    "\nout vec4 shadertoy_out_color;\nvoid main() {\n    vec4 color = vec4(1e20);\n"
    "    mainImage(color, gl_FragCoord.xy);\n    shadertoy_out_color = color;\n}\n";

/* The site compiles Common alone too, and then without the inputs of the others. */
static void compile(const char *folder, const char *tab) {
    Text common = read_tab(folder, "common.glsl"), own = {0}, whole = {0};
    char command[1200];
    if (tab) own = read_tab(folder, tab);
    text_print(&whole, "%s%s%s\n%s%s", es_head,
               tab ? tab_head
                   : "uniform vec4 iDate;\nuniform float iSampleRate;\nout vec4 outColor;\n"
                     "void main() { outColor = vec4(0.0); }\n",
               text_string(&common), text_string(&own), tab ? tab_tail : "");
    const char *path = support_write("tab.frag", text_string(&whole));
    snprintf(command, sizeof command, "glslangValidator '%s' > '%s'", path, support_path("log"));
    if (system(command) != 0) {
        Text log = read_text(support_path("log"));
        fail_msg("%s, %s: %.600s", folder, tab ? tab : "Common alone", text_string(&log));
    }
    text_free(&common);
    text_free(&own);
    text_free(&whole);
}

static void compile_all(const char *folder) {
    compile(folder, NULL);
    compile(folder, "buffer-a.glsl");
    compile(folder, "image.glsl");
}

static bool has_glslang(void) {
    return system("command -v glslangValidator > /dev/null") == 0;
}

/* Bytes of the tab Common. */
static size_t common_size(const char *folder) {
    Text text = read_tab(folder, "common.glsl");
    size_t size = text.size;
    assert_null(strstr(text_string(&text), "\nuniform "));
    assert_null(strstr(text_string(&text), "#version"));
    assert_null(strstr(text_string(&text), "#line"));
    text_free(&text);
    return size;
}

static const char *name_of(const char *path) {
    return strrchr(path, '/') + 1;
}

/* Every scene is held, or refused with the reason. */
static void test_scenes(void **state) {
    (void)state;
    /* Bytes of Common, at most. The two loops of a march are 3 kB of valley's, which has the most else. */
    static const struct {
        const char *name;
        size_t most;
    } bounds[] = {
        {"crater.glsl", 40000}, {"gyroid.glsl", 40000}, {"materials.glsl", 40000}, {"valley.glsl", 43000}};
    SceneList scenes = scene_list();
    const char *folder = support_path("scene");
    for (int i = 0; i < scenes.count; i++) {
        const char *path = scenes.paths[i];
        Text text = read_text(path);
        bool spheres = strstr(text_string(&text), "//@ spheres");
        text_free(&text);
        if (spheres) {
            support_expect(3, "hit_spheres()", "export %s --shadertoy -o '%s' " HELD, path, folder);
            continue;
        }
        support_expect(0, "", "export %s --shadertoy -o '%s' " HELD, path, folder);
        size_t size = common_size(folder);
        size_t most = 60000;
        for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++)
            if (strcmp(name_of(path), bounds[k].name) == 0) most = bounds[k].most;
        if (size > most) fail_msg("%s: Common has %zu bytes", path, size);
        if (has_glslang()) compile_all(folder);
    }
    if (!has_glslang()) printf("glslangValidator is not there: the texts were not compiled\n");
}

/* relRMSE in percent without pixel (0, 0), which holds no light. */
static double difference(const Image *a, const Image *b) {
    assert_true(a->width == b->width && a->height == b->height);
    size_t corner = (size_t)(a->height - 1) * (size_t)a->width, count = 0;
    double squares = 0, sum = 0;
    for (size_t i = 0; i < (size_t)a->width * (size_t)a->height; i++) {
        for (int c = 0; c < 3 && i != corner; c++, count++) {
            double d = (double)a->rgba[4 * i + (size_t)c] - (double)b->rgba[4 * i + (size_t)c];
            squares += d * d;
            sum += (double)b->rgba[4 * i + (size_t)c];
        }
    }
    return 100 * sqrt(squares / (double)count) / (sum / (double)count);
}

static Image read_picture(const char *name) {
    Image image;
    Error error;
    if (!image_read(&image, support_path(name), &error)) fail_msg("%s", error.text);
    return image;
}

/* Exports a scene, draws so many frames of Buffer A and of Image, and compares them with the scene's own
 * pictures. Returns the relRMSE of the radiances. */
static double round_trip(const char *scene, const char *options, const char *size, int samples) {
    const char *folder = support_path("trip");
    support_expect(0, "", "export %s --shadertoy -o '%s' %s", scene, folder, options);
    support_expect(0, "", "render '%s/buffer-a.glsl' --size %s --frames %d -o '%s'", folder, size, samples,
                   support_path("toy.exr"));
    support_expect(0, "", "render '%s' --size %s --frames %d -o '%s'", folder, size, samples,
                   support_path("toy.png"));
    support_expect(0, "", "render %s --light cosine --sky gauss:6 %s --size %s --spp %d -o '%s' -o '%s'",
                   scene, options, size, samples, support_path("own.exr"), support_path("own.png"));
    Image toy = read_picture("toy.exr"), own = read_picture("own.exr"), shown = read_picture("toy.png"),
          wanted = read_picture("own.png");
    double apart = difference(&toy, &own);
    size_t pixels = (size_t)own.width * (size_t)own.height, other = 0;
    for (size_t i = 0; i < pixels; i++) {
        for (size_t c = 0; c < 3; c++) other += shown.rgba[4 * i + c] != wanted.rgba[4 * i + c];
    }
    printf("%s: relRMSE %.5f %%, %zu of %zu bytes shown differ\n", scene, apart, other, 3 * pixels);
    /* The pixel in the corner shows its neighbour. */
    assert_true((double)other <= 3 + 0.01 * 3 * (double)pixels);
    image_free(&toy);
    image_free(&own);
    image_free(&shown);
    image_free(&wanted);
    return apart;
}

/* The same seed gives the same picture, up to the last digits of a float. */
static void test_round_trip(void **state) {
    (void)state;
    need_gl();
    int samples = (int)support_samples(32);
    assert_true(round_trip("scenes/crater.glsl", "", "160x90", samples) < 0.01);
    assert_true(round_trip("scenes/gyroid.glsl", HELD, "160x90", samples) < 0.05);
    assert_true(round_trip("scenes/materials.glsl", HELD, "160x90", samples) < 0.05);
    assert_true(round_trip("scenes/valley.glsl", HELD, "160x90", samples) < 0.1);
    /* Mist, lamps, air, and a camera that looks straight up. */
    assert_true(round_trip("scenes/shafts.glsl", HELD, "64x48", 8) < 0.05);
    assert_true(round_trip("scenes/box-room.glsl", "--seed 3 --depth 4", "48x64", 8) < 0.05);
    assert_true(round_trip("scenes/valley.glsl", HELD " --preset kilometres", "64x36", 8) < 0.1);
    assert_true(round_trip("scenes/crater.glsl", "--set camera.target=0,3,-4 --sun 4,130", "40x40", 8) <
                0.05);
}

/* Where the mouse is the sun is; where it was when the sums began is kept, and when it moves they restart. */
static void test_mouse(void **state) {
    (void)state;
    need_gl();
    const char *folder = support_path("mouse");
    support_expect(0, "", "export scenes/crater.glsl --shadertoy -o '%s'", folder);
    support_expect(0, "", "render '%s/buffer-a.glsl' --size 64x36 --frames 8 --set mouse=16,18,16,18 -o '%s'",
                   folder, support_path("moved.exr"));
    /* From -10 to 90 upward, and from 0 to 360 to the right. */
    support_expect(
        0, "",
        "render scenes/crater.glsl --light cosine --sky gauss:6 --sun 40,90 --size 64x36 --spp 8 -o "
        "'%s'",
        support_path("sun.exr"));
    Image moved = read_picture("moved.exr"), sun = read_picture("sun.exr");
    assert_true(difference(&moved, &sun) < 0.05);
    image_free(&moved);
    image_free(&sun);

    /* A mouse that moves with the frames leaves one sample of each pixel: the corner has what it was made
     * for. */
    Text buffer = read_tab(folder, "buffer-a.glsl"), edited = {0};
    char *mouse = strstr(buffer.data, "iMouse.xy);");
    assert_non_null(mouse);
    text_print(&edited, "%.*svec2(float(iFrame / 5), 0.0));%s", (int)(mouse - buffer.data), buffer.data,
               mouse + strlen("iMouse.xy);"));
    char path[600];
    Error error;
    snprintf(path, sizeof path, "%s/buffer-a.glsl", folder);
    assert_true(file_replace(path, edited.data, edited.size, &error));
    support_expect(0, "", "render '%s' --size 64x36 --frames 8 -o '%s'", path, support_path("restarted.exr"));
    support_expect(
        0, "",
        "render scenes/crater.glsl --light cosine --sky gauss:6 --size 64x36 --first-sample 5 --spp 3 "
        "-o '%s'",
        support_path("last.exr"));
    Image restarted = read_picture("restarted.exr"), last = read_picture("last.exr");
    assert_true(difference(&restarted, &last) < 0.05);
    const float *corner = restarted.rgba + 4 * 35 * 64;
    assert_true(corner[0] == 64 && corner[1] == 36 && corner[2] == 1);
    image_free(&restarted);
    image_free(&last);
    text_free(&buffer);
    text_free(&edited);
}

/* Values of the scene, of presets and of options, with their words. */
static void test_settings(void **state) {
    (void)state;
    const char *folder = support_path("settings");
    support_expect(0, "",
                   "export scenes/crater.glsl --shadertoy -o '%s' --preset sunset --set hover=1.25 --set "
                   "ball=off --seed 7 --depth 9",
                   folder);
    expect_words(folder, "common.glsl",
                 "// height of the ball's centre, from -0.5 to 3 m.\nconst float hover = 1.25;\n");
    expect_words(folder, "common.glsl", "// mirror ball.\nconst bool ball = false;\n");
    expect_words(folder, "common.glsl", "const vec2 SUN = vec2(5.0, 0.0);\n");
    expect_words(folder, "common.glsl", "const float EXPOSURE_EV = 0.5;\n");
    expect_words(folder, "common.glsl", "const int MOST_HITS = 9;\nconst uint SEED = 7u;\n");
    expect_words(folder, "common.glsl", "normalize(vec3(0.0, 0.0, 0.0) - CAMERA_EYE)\n");
    expect_words(folder, "common.glsl", "--preset sunset --set hover=1.25");
    expect_words(folder, "buffer-a.glsl", "Set iChannel0 to Buffer A itself");
    expect_words(folder, "image.glsl", "const float gain = exp2(EXPOSURE_EV);");
    support_expect(0, "", "export scenes/mirrors.glsl --shadertoy -o '%s' --set tint=1,0.25,0.1 " HELD,
                   folder);
    expect_words(folder, "common.glsl", "const vec3 tint = vec3(1.0, 0.25, 0.1);\n");
    /* The six nodes of the sky are a table of six by six. */
    expect_words(folder, "common.glsl", "float[6](0.03376524,");
    expect_words(folder, "common.glsl", "float[36](");
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
    if (has_glslang()) compile_all(folder);
    expect_words(folder, "common.glsl", "const float own_tone = 0.5;");
    expect_words(folder, "common.glsl", "const bool MOUSE_MOVES_SUN = false;");
    expect_words(folder, "common.glsl", "/* a comment\n   of two lines */\n");
    expect_words(folder, "common.glsl", "const float scene_iTime = 2.0;");
    expect_words(folder, "buffer-a.glsl", "    scene_iResolution = iResolution;\n");
    expect_words(folder, "buffer-a.glsl", "    scene_iFrame = iFrame;\n");
    need_gl();
    char path[700];
    snprintf(path, sizeof path, "'%s'", scene);
    assert_true(round_trip(path, "--set time=2 --set mouse=20,3,0,0", "40x30", 8) < 0.05);
}

/* What cannot be held is refused, with the place of what asks for it. */
static void test_refused(void **state) {
    (void)state;
    const char *folder = support_path("refused");
    static const struct {
        int status;
        const char *words, *arguments;
    } cases[] = {
        {3, "scenes/materials.glsl:5: Shadertoy's texts do not hold light that is scattered more than once",
         "scenes/materials.glsl"},
        {3, "scenes/shafts.glsl:5: Shadertoy's texts do not hold the sun's disk",
         "scenes/shafts.glsl --orders 1 --set atmosphere.ground_albedo=0"},
        {3, "the tree of hit_spheres()", "scenes/spheres.glsl " HELD},
        {3, "light that is scattered more than once", "scenes/crater.glsl --orders 2"},
        {2, "--sun-disk auto: Shadertoy's texts", "scenes/crater.glsl --sun-disk"},
        {2, "--sun-disk chance: Shadertoy's texts", "scenes/crater.glsl --sun-disk=chance"},
        {2, "--sky table:gauss:8: Shadertoy's texts", "scenes/crater.glsl --sky table"},
        {2, "--light control: Shadertoy's texts", "scenes/crater.glsl --light control"},
        {2, "--light mis: Shadertoy's texts", "scenes/crater.glsl --light mis"},
        {2, "--sequence metropolis: Shadertoy's texts", "scenes/crater.glsl --sequence metropolis"},
        {2, "unknown method 'gaus'", "scenes/crater.glsl --sky gaus"},
        {3, "cannot be read", "scenes/no-such.glsl"},
        {2, "paints its picture by itself", "tests/data/toys/plain.glsl"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        support_expect(cases[i].status, cases[i].words, "export %s --shadertoy -o '%s'", cases[i].arguments,
                       folder);
        assert_int_not_equal(access(folder, F_OK), 0);
    }
    /* A direct method is held, whichever it is. */
    support_expect(0, "",
                   "export scenes/crater.glsl --shadertoy -o '%s' --sky paper:8x2 --light paper --sequence "
                   "additive",
                   folder);
    if (has_glslang()) compile_all(folder);
    support_expect(
        0, "", "export scenes/author-room.glsl --shadertoy -o '%s' --light portal --sequence random", folder);
    if (has_glslang()) compile_all(folder);
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
    if (has_glslang()) compile_all(folder);
    expect_words(folder, "common.glsl", "const float size = 1.0;\nconst int COUNT = 3;\n");
    expect_words(folder, "common.glsl", "        int k = i * 2 + 1;\n        float n = -1.0;\n");
    expect_words(folder, "common.glsl", "1.0 * size / 2.0, i + 1, hit);");
    need_gl();
    char path[700];
    snprintf(path, sizeof path, "'%s'", scene);
    assert_true(round_trip(path, "", "40x30", 8) < 0.05);
}

/* Folders that are there, are files, or cannot be made; a file that cannot be replaced. */
static void test_folder(void **state) {
    (void)state;
    char command[700];
    struct stat found;
    const char *folder = support_path("there"), *file = support_write("file", "words\n");
    snprintf(command, sizeof command, "mkdir '%s'", folder);
    assert_int_equal(system(command), 0);
    support_expect(0, "", "export scenes/crater.glsl --shadertoy -o '%s'", folder);
    support_expect(0, "", "export scenes/crater.glsl --shadertoy -o '%s'", folder);
    support_expect(5, "it is a file", "export scenes/crater.glsl --shadertoy -o '%s'", file);
    Text text = read_text(file);
    assert_string_equal(text_string(&text), "words\n");
    text_free(&text);
    support_expect(5, "no folder can be made there", "export scenes/crater.glsl --shadertoy -o '%s/a/b'",
                   file);
    snprintf(command, sizeof command, "rm '%s'/*.glsl && mkdir '%s/image.glsl'", folder, folder);
    assert_int_equal(system(command), 0);
    support_expect(5, "image.glsl", "export scenes/crater.glsl --shadertoy -o '%s'", folder);
    assert_int_not_equal(stat(support_path("there/common.glsl"), &found), 0);
    assert_int_not_equal(stat(support_path("there/buffer-a.glsl"), &found), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes),   cmocka_unit_test(test_round_trip),    cmocka_unit_test(test_mouse),
        cmocka_unit_test(test_settings), cmocka_unit_test(test_names),         cmocka_unit_test(test_refused),
        cmocka_unit_test(test_language), cmocka_unit_test(test_whole_numbers), cmocka_unit_test(test_folder),
    };
    return cmocka_run_group_tests_name("export --shadertoy", tests, support_folder, support_clean);
}
