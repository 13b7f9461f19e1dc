/* `export --shadertoy`: the texts as the site takes them, and the pictures that they draw when they are given
 * back to `render`. */
#include "scene_list.h"
#include "support.h"
#include "tabs.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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
        {"crater.glsl", 40000}, {"gyroid.glsl", 40000}, {"materials.glsl", 40000}, {"valley.glsl", 45000}};
    SceneList scenes = scene_list();
    const char *folder = support_path("scene");
    for (int i = 0; i < scenes.count; i++) {
        const char *path = scenes.paths[i];
        Text text = tabs_read_file(path);
        bool spheres = strstr(text_string(&text), "//@ spheres");
        text_free(&text);
        if (spheres) {
            support_expect(3, "hit_spheres()", "export %s --shadertoy -o '%s' " TABS_HELD, path, folder);
            continue;
        }
        support_expect(0, "", "export %s --shadertoy -o '%s' " TABS_HELD, path, folder);
        size_t size = tabs_common_size(folder);
        size_t most = 60000;
        for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++)
            if (strcmp(name_of(path), bounds[k].name) == 0) most = bounds[k].most;
        if (size > most) fail_msg("%s: Common has %zu bytes", path, size);
        tabs_compile(folder);
    }
}

/* The same seed gives the same picture, up to the last digits of a float. */
static void test_round_trip(void **state) {
    (void)state;
    tabs_need_gl();
    int samples = (int)support_samples(32);
    assert_true(tabs_round_trip("scenes/crater.glsl", "", "160x90", samples) < 0.01);
    assert_true(tabs_round_trip("scenes/gyroid.glsl", TABS_HELD, "160x90", samples) < 0.05);
    assert_true(tabs_round_trip("scenes/materials.glsl", TABS_HELD, "160x90", samples) < 0.05);
    assert_true(tabs_round_trip("scenes/valley.glsl", TABS_HELD, "160x90", samples) < 0.1);
    /* Mist, lamps, air, and a camera that looks straight up. */
    assert_true(tabs_round_trip("scenes/shafts.glsl", TABS_HELD, "64x48", 8) < 0.05);
    assert_true(tabs_round_trip("scenes/box-room.glsl", "--seed 3 --depth 4", "48x64", 8) < 0.05);
    assert_true(tabs_round_trip("scenes/valley.glsl", TABS_HELD " --preset kilometres", "64x36", 8) < 0.1);
    assert_true(tabs_round_trip("scenes/crater.glsl", "--set camera.target=0,3,-4 --sun 4,130", "40x40", 8) <
                0.05);
}

/* Where the mouse is the sun is; where it was when the sums began is kept, and when it moves they restart. */
static void test_mouse(void **state) {
    (void)state;
    tabs_need_gl();
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
    Image moved = tabs_picture("moved.exr"), sun = tabs_picture("sun.exr");
    assert_true(tabs_difference(&moved, &sun) < 0.05);
    image_free(&moved);
    image_free(&sun);

    /* A mouse that moves with the frames leaves one sample of each pixel: the corner has what it was made
     * for. */
    Text buffer = tabs_read(folder, "buffer-a.glsl"), edited = {0};
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
    Image restarted = tabs_picture("restarted.exr"), last = tabs_picture("last.exr");
    assert_true(tabs_difference(&restarted, &last) < 0.05);
    const float *corner = restarted.rgba + 4 * 35 * 64;
    assert_true(corner[0] == 64 && corner[1] == 36 && corner[2] == 1);
    image_free(&restarted);
    image_free(&last);
    text_free(&buffer);
    text_free(&edited);
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
        {3, "the tree of hit_spheres()", "scenes/spheres.glsl " TABS_HELD},
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
    tabs_compile(folder);
    support_expect(
        0, "", "export scenes/author-room.glsl --shadertoy -o '%s' --light portal --sequence random", folder);
    tabs_compile(folder);
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
    Text text = tabs_read_file(file);
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
        cmocka_unit_test(test_scenes),  cmocka_unit_test(test_round_trip), cmocka_unit_test(test_mouse),
        cmocka_unit_test(test_refused), cmocka_unit_test(test_folder),
    };
    return cmocka_run_group_tests_name("export --shadertoy", tests, support_folder, support_clean);
}
