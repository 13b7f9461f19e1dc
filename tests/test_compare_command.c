/* `compare` as it is used: pictures of other programs, what it prints, and what it writes. */
#include "exr_files.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A picture of that size, of one value but for one pixel's red. */
static const char *write_picture(const char *name, int width, int height, float value, float red, int pixel) {
    Error error;
    const char *path = support_path(name);
    Image image = image_create(width, height);
    for (int i = 0; i < 4 * width * height; i++) image.rgba[i] = value;
    image.rgba[4 * pixel] = red;
    if (!image_write(&image, path, &(ImageWriteParams){.tone = TONE_NONE}, &error))
        fail_msg("%s", error.text);
    image_free(&image);
    return path;
}

static void expect_line(const char *line) {
    if (!strstr(support_out, line)) fail_msg("'%s' lacks '%s'", support_out, line);
}

static void test_command_layers(void **state) {
    (void)state;
    const char *many = support_path("many.exr"), *one = support_path("one.exr");
    exr_file_write(many, &(ExrFile){.parts = {{"albedo", "R G B"}, {"beauty", "R G B"}}});
    exr_file_write(one, &(ExrFile){.parts = {{NULL, "R G B"}}});
    support_expect(0, "", "compare '%s' '%s' --layer albedo --layer '' --max-relrmse 0", many, one);
    expect_line("read A       layer 'albedo' of 2\nrelRMSE");
    support_expect(0, "", "compare '%s' '%s' --layer '' --layer albedo --max-relrmse 0", one, many);
    expect_line("read B       layer 'albedo' of 2\nrelRMSE");
    support_expect(0, "", "compare '%s' '%s' --layer albedo --max-relrmse 0", many, many);
    support_expect(6, "differs from", "compare '%s' '%s' --max-relrmse 1", many, one);
    support_expect(1, "one.exr: no layer 'albedo'; its layers: '' (R, G, B)",
                   "compare '%s' '%s' --layer albedo", many, one);
    support_expect(2, "--layer more than 2 times", "compare '%s' '%s' --layer a --layer b --layer c", many,
                   one);
}

static void test_command_outside(void **state) {
    (void)state;
    const char *part = support_path("part.exr"), *all = support_path("all.exr");
    exr_file_write(part,
                   &(ExrFile){.parts = {{NULL, "R G B"}}, .data = {2, 3, 4, 5}, .display = {0, 0, 10, 9}});
    exr_file_write(all,
                   &(ExrFile){.parts = {{NULL, "R G B"}}, .data = {0, 0, 10, 9}, .display = {0, 0, 10, 9}});
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 0", part, all);
    expect_line("read A       display window of 10x9, data window of 4x5 at 2,3 in it\n");
    expect_line("pixels       20, 0 not finite\noutside      70 left out");
}

static void test_command_nonfinite(void **state) {
    (void)state;
    const char *a = write_picture("nan.pfm", 7, 5, 1, NAN, 2 * 7 + 3),
               *b = write_picture("1.pfm", 7, 5, 1, 1, 0);
    support_expect(0, "", "compare '%s' '%s'", a, b);
    expect_line("pixels       35, 1 not finite, the first at 3,2\n");
    support_expect(6, "1 pixels are not finite, the first at 3,2", "compare '%s' '%s' --max-relrmse 5", a, b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_command_layers),
        cmocka_unit_test(test_command_outside),
        cmocka_unit_test(test_command_nonfinite),
    };
    return cmocka_run_group_tests_name("compare_command", tests, support_folder, support_clean);
}
