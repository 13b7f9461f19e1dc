/* The command in a picture's metadata makes the same picture again, run by a shell as it stands. */
#include "support.h"

#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char scene_text[] =
    "//@ sun elevation 20\n#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit); }\n"
    "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n";

/* Runs the recorded command of a picture that has been moved aside, and compares. */
static void make_again(const char *path) {
    Text command = {0}, quoted = {0};
    const char *first = support_path("first.exr");
    assert_true(support_attribute(path, "magichour.command", &command));
    assert_int_equal(rename(path, first), 0);
    text_print(&command, " >'%s' 2>&1", support_path("stdout"));
    if (system(text_string(&command)) != 0) fail_msg("%s", text_string(&command));
    text_print_quoted(&quoted, path);
    assert_int_equal(support_run("", "compare '%s' %s --max-relrmse 0", first, text_string(&quoted)), 0);
    text_free(&command);
    text_free(&quoted);
}

static void test_render(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    context_close(&context);
    Text words = {0};
    const char *scene = support_write("a \"scene\" of $HOME's.glsl", scene_text);
    const char *library = support_path("the library"), *picture = support_path("a picture; 'one'.exr");
    char *here = realpath("glsl", NULL);
    assert_int_equal(symlink(here, library), 0);
    free(here);
    text_print_quoted(&words, scene);
    text_print(&words, " --glsl-dir ");
    text_print_quoted(&words, library);
    text_print(&words, " -o ");
    text_print_quoted(&words, picture);
    support_expect(0, "", "render %s --size 16x16 --spp 4 --seed 3 --quiet", text_string(&words));
    make_again(picture);
    text_free(&words);
}

/* iTime and iMouse are settings, so that they are in the command, and they change the picture. */
static void test_inputs(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    context_close(&context);
    const char *scene = support_write(
        "moving.glsl",
        "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit); }\n"
        "Material scene_material(Hit hit) {\n"
        "    return matte(vec3(0.1 * iTime, 0.001 * iMouse.x, -0.001 * iMouse.w)); }\n");
    const char *picture = support_path("moving.exr"), *still = support_path("still.exr");
    support_expect(0, "", "render '%s' --set time=3.3 --set mouse=700,2,3,-400.5 %s -o '%s'", scene,
                   "--size 8x8 --spp 4 --quiet", picture);
    support_expect(0, "", "render '%s' --size 8x8 --spp 4 --quiet -o '%s'", scene, still);
    Text value = {0};
    assert_true(support_attribute(picture, "magichour.time", &value));
    text_print(&value, " ");
    assert_true(support_attribute(picture, "magichour.mouse", &value));
    assert_string_equal(text_string(&value), "3.3 700,2,3,-400.5");
    text_free(&value);
    assert_false(support_attribute(still, "magichour.time", &value));
    assert_false(support_attribute(still, "magichour.mouse", &value));
    make_again(picture);
    assert_int_equal(support_run("", "compare '%s' '%s' --max-relrmse 10", picture, still), 6);
    support_expect(2, "mouse: '3' is not four numbers a,b,c,d", "render '%s' --set mouse=3 -o '%s'", scene,
                   still);
    support_expect(2, "mouse: '1,2,3' is not four numbers", "render '%s' --set mouse=1,2,3 -o '%s'", scene,
                   still);
    support_expect(2, "mouse: '1,2,3,4,5' is not four", "render '%s' --set mouse=1,2,3,4,5 -o '%s'", scene,
                   still);
}

static void test_sky(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    context_close(&context);
    const char *picture = support_path("the sky.exr");
    support_expect(0, "", "sky --size 16x8 --sun 12 --quiet -o '%s'", picture);
    make_again(picture);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_render),
        cmocka_unit_test(test_inputs),
        cmocka_unit_test(test_sky),
    };
    return cmocka_run_group_tests_name("command", tests, support_folder, support_clean);
}
