/* The command in a picture's metadata makes the same picture again, run by a shell as it stands. */
#include "support.h"

#include "base/text.h"
#include "image/exr_attribute.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char scene_text[] =
    "//@ sun elevation 20\n#include \"shape/plane.glsl\"\n"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit); }\n"
    "Material scene_material(Hit hit) { return material_new(0, vec3(0.5)); }\n";

/* Runs the recorded command of a picture that has been moved aside, and compares. */
static void make_again(const char *path) {
    Text command = {0}, quoted = {0};
    const char *first = support_path("first.exr");
    assert_true(exr_attribute(path, "magichour.command", &command));
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
        cmocka_unit_test(test_sky),
    };
    return cmocka_run_group_tests_name("command", tests, support_folder, support_clean);
}
