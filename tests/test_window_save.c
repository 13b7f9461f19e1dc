/* What the window saves: the picture that it shows, with what makes it again. */
#include "desktop.h"

#include "base/file.h"
#include "base/memory.h"
#include "image/format.h"

#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SMALL "--size 320x180"

/* The `render` command that a PNG was saved with, in the text of its metadata. */
static void saved_command(const char *png, char *command, size_t size) {
    Text file = {0};
    Error error;
    if (!file_read(png, STATUS_FAILURE, &file, &error)) fail_msg("%s", error.text);
    const char *start = NULL;
    for (size_t i = 0; i + 17 < file.size && !start; i++) {
        if (memcmp(file.data + i, "magichour render ", 17) == 0) start = file.data + i + strlen("magichour ");
    }
    assert_non_null(start);
    size_t length = 0;
    while (start[length] >= ' ' && start[length] < 127 && length + 1 < size) length++;
    /* What follows the text is four bytes of checksum, which may be printable, so that the end is looked for.
     */
    snprintf(command, size, "%.*s", (int)length, start);
    text_free(&file);
}

/* To one step of 256 everywhere, and to none but in this share of the values. */
static void compare_with_screen(const char *png, double most_different) {
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_file(&image, png));
    image.format = PNG_FORMAT_RGB;
    unsigned char *bytes = memory_get(PNG_IMAGE_SIZE(image), 1);
    assert_true(png_image_finish_read(&image, NULL, bytes, 0, NULL));
    int different = 0, far = 0, values = 0;
    for (unsigned y = 10; y < image.height; y += 9) {
        for (unsigned x = 0; x < image.width; x += 7) {
            int rgb[3];
            desktop_pixel(window, (int)x, (int)y, rgb);
            for (int c = 0; c < 3; c++) {
                int apart = abs(rgb[c] - bytes[3 * (y * image.width + x) + (unsigned)c]);
                values++;
                different += apart > 0;
                far += apart > 1;
            }
        }
    }
    free(bytes);
    assert_int_equal(far, 0);
    assert_true(different <= most_different * values);
}

static void test_save(void **state) {
    (void)state;
    char command[4096];
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --spp 48 --seed 7 --set hover=0.75");
    desktop_do(window, "key h mousemove 100 90 mousedown 1 mousemove 110 93 mouseup 1 key 3");
    desktop_expect_done(window, 48);
    desktop_do(window, "mousemove 700 500 key p"); /* the pointer out of the picture */
    const char *line = desktop_expect(window, "\"event\": \"save\"", "\"message\": \"\"");
    assert_non_null(strstr(line, "crater-001"));
    compare_with_screen(support_path("crater-001.png"), 0.003);
    desktop_quit(window);
    saved_command(support_path("crater-001.png"), command, sizeof command);
    char *end = strstr(command, " --set hover=0.75");
    assert_non_null(end);
    end[strlen(" --set hover=0.75")] = 0;
    char *output = strstr(command, "-o picture.exr ");
    assert_non_null(output);
    memset(output, ' ', strlen("-o picture.exr "));
    const char *again = support_path("again.exr"), *saved = support_path("crater-001.exr");
    assert_int_equal(support_run("", "%s --quiet -o '%s'", command, again), 0);
    assert_int_equal(support_run("", "compare '%s' '%s' --max-relrmse 0", saved, again), 0);
}

/* The coarse tables of previews leave nothing behind: after the sun and the camera were dragged, a picture at
 * rest under the sky with all orders, with the sun's disk, is what `render` makes. */
static void test_save_after_previews(void **state) {
    (void)state;
    Text file = {0}, command = {0};
    Error error;
    desktop_view(window, "\"$here\"/scenes/sundial.glsl --size 200x120 --spp 16");
    desktop_expect_done(window, 16);
    desktop_do(window,
               "key h mousemove 100 60 mousedown 3 mousemove 110 66 sleep 0.05 mousemove 112 70 sleep 0.4 "
               "mousemove 90 60 sleep 0.02 mousemove 80 60 mouseup 3 mousedown 1 mousemove 84 62 mouseup 1");
    desktop_expect_done(window, 16);
    const char *saved = desktop_save(window, "exr");
    desktop_quit(window);
    assert_true(file_read(saved, STATUS_FAILURE, &file, &error));
    assert_true(image_attribute(&file, "magichour.command", &command));
    char *output = strstr(command.data, "-o picture.exr ");
    memset(output, ' ', strlen("-o picture.exr "));
    const char *again = support_path("again.exr");
    assert_int_equal(support_run("", "%s --quiet -o '%s'", command.data + strlen("magichour "), again), 0);
    assert_int_equal(support_run("", "compare '%s' '%s' --max-relrmse 0", saved, again), 0);
    text_free(&file);
    text_free(&command);
}

/* A link line holds all that differs from the scene's file, and nothing else; a window that is opened by it
 * shows the same. */
static void test_link(void **state) {
    (void)state;
    char link[2048];
    desktop_view(window, "\"$here\"/scenes/crater.glsl --size 512x512");
    desktop_do(window, "key l");
    const char *line = desktop_expect(window, "\"event\": \"copy\"", "magichour view ");
    assert_non_null(strstr(line, "/scenes/crater.glsl\"")); /* and no more */
    desktop_quit(window);
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --light cosine --set hover=0.75 --spp 16");
    desktop_do(
        window,
        "key h mousemove 100 90 mousedown 1 mousemove 110 93 mouseup 1 mousemove 700 500 key 3 key equal");
    desktop_expect_done(window, 16);
    const char *first = desktop_save(window, "exr");
    desktop_do(window, "key l");
    line = desktop_expect(window, "\"event\": \"copy\"", "magichour view ");
    assert_int_equal(sscanf(strstr(line, "magichour view ") + strlen("magichour view "), "%2047[^\"]", link),
                     1);
    assert_non_null(strstr(link, " --size 320x180 --light cosine --sun 5,0 "));
    assert_non_null(strstr(link, " --exposure 0.75 --set hover=0.75"));
    double eye = desktop_number(window, "eye_x");
    desktop_quit(window);
    desktop_view(window, "%s --spp 16", link);
    desktop_expect_samples(window, 16);
    assert_true(desktop_number(window, "eye_x") == eye && desktop_number(window, "exposure") == 0.75);
    const char *second = desktop_save(window, "exr");
    desktop_quit(window);
    assert_string_not_equal(first, second);
    assert_int_equal(support_run("", "compare '%s' '%s' --max-relrmse 0", first, second), 0);
}

/* A scene that follows the clock and the mouse, with blanks and quotes in its path and the library's: the
 * saved command makes what was on the screen when it was saved, to the bit, run by a shell as it stands. */
static void test_save_moving(void **state) {
    (void)state;
    char words[1024];
    Text command = {0}, scene = {0}, library = {0};
    char *here = realpath("glsl", NULL), *program = realpath(getenv("MAGICHOUR"), NULL);
    assert_int_equal(symlink(here, support_path("the library's")), 0);
    text_print_quoted(&library, support_path("the library's"));
    text_print_quoted(
        &scene,
        support_write(
            "it's moving.glsl",
            "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
            "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit); }\n"
            "Material scene_material(Hit hit) {\n"
            "    return matte(vec3(0.5 + 0.4 * sin(iTime), 0.001 * iMouse.x, 0.001 * iMouse.y)); "
            "}\n"));
    desktop_view(window, "%s --glsl-dir %s " SMALL " --spp 16", text_string(&scene), text_string(&library));
    desktop_do(window,
               "key h mousemove 100 90 mousedown 1 mousemove 110 93 mouseup 1 key space sleep 0.3 key space");
    desktop_expect_done(window, 16);
    desktop_do(window, "mousemove 700 500");
    const char *saved = desktop_save(window, "exr");
    desktop_quit(window);
    assert_true(support_attribute(saved, "magichour.command", &command));
    assert_non_null(strstr(text_string(&command), " --set time="));
    assert_non_null(strstr(text_string(&command), " --set mouse=110,87,-100,-90"));
    Text script = {0};
    text_print(&script, "cd \"$(dirname \"$0\")\" || exit 1\nmagichour() { '%s' \"$@\" --quiet; }\n%s\n",
               program, text_string(&command));
    snprintf(words, sizeof words, "sh '%s'", support_write("again.sh", text_string(&script)));
    if (system(words) != 0) fail_msg("%s", text_string(&command));
    text_free(&scene);
    text_print_quoted(&scene, saved);
    assert_int_equal(
        support_run("", "compare %s '%s' --max-relrmse 0", text_string(&scene), support_path("picture.exr")),
        0);
    text_free(&script);
    text_free(&command);
    text_free(&scene);
    text_free(&library);
    free(here);
    free(program);
}

static double channel_mean(const Image *image, int channel, bool negative) {
    double sum = 0;
    int pixels = image->width * image->height;
    for (int i = 0; i < pixels; i++) {
        double value = (double)image->rgba[4 * i + channel];
        sum += negative ? fmin(value, 0) : fmax(value, 0);
    }
    return sum / pixels;
}

/* Both sides, and their difference in false colours, which the screen does not dither. */
static void test_save_sides(void **state) {
    (void)state;
    Image image;
    Error error;
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --spp 32");
    desktop_do(window, "mousemove 40 90 key h key i key v mousemove 700 500");
    desktop_expect(window, "\"sides\": 2", "\"rests\": 1");
    const char *sides = desktop_save(window, "png");
    compare_with_screen(sides, 0.003);
    desktop_do(window, "key f");
    desktop_expect_number(window, "difference", 10, 10);
    compare_with_screen(desktop_save(window, "png"), 0.4);
    const char *difference = desktop_save(window, "exr");
    desktop_quit(window);
    assert_true(image_read(&image, difference, &error));
    double below = channel_mean(&image, 1, true), above = channel_mean(&image, 1, false);
    assert_true(below < 0 && fabs(above / below + 1) < 0.3);
    image_free(&image);
}

/* The pixel under the pointer, in the plane's front: its numbers are the saved picture's, and its depth that
 * of the plane, along the camera's axis. */
static void test_inspect(void **state) {
    (void)state;
    enum { X = 200, Y = 160 };
    static const char *const channels[] = {"pixel_red", "pixel_green", "pixel_blue"};
    Image image;
    Error error;
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --spp 32");
    desktop_do(window, "mousemove %d %d key i", X, Y);
    desktop_expect(window, "\"rests\": 1", "\"pixel_x\": 200, \"pixel_y\": 160");
    desktop_settle(window); /* The pixel's numbers are of the last sample too. */
    const char *path = desktop_save(window, "exr");
    assert_true(image_read(&image, path, &error));
    for (int c = 0; c < 3; c++) {
        double saved = (double)image.rgba[4 * (Y * image.width + X) + c];
        assert_true(fabs(desktop_number(window, channels[c]) - saved) < 1e-6 * saved);
    }
    image_free(&image);
    assert_true(desktop_number(window, "pixel_samples") == 32);
    /* Eye 2 m high, looking down by atan(1/2), 90 degrees high. */
    double up = 1 - (Y + 0.5) / 90, sink = (1 - 2 * up) / sqrt(5);
    assert_true(fabs(desktop_number(window, "pixel_depth") * sink / 2 - 1) < 0.01);
    double albedo = desktop_number(window, "pixel_albedo"),
           percent = desktop_number(window, "pixel_error_percent");
    assert_true(albedo > 0.099 && albedo < 0.801 && percent > 0 && percent < 50);
    desktop_quit(window);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_save, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_save_after_previews, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_link, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_save_moving, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_save_sides, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_inspect, desktop_setup, desktop_teardown),
    };
    return cmocka_run_group_tests_name("window_save", tests, support_folder, support_clean);
}
