/* PNG files of all kinds, written by libpng. */
#include "support.h"

#include "base/file.h"
#include "base/memory.h"
#include "image/codec.h"
#include "image/png_attribute.h"
#include "image/tone.h"

#include <math.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>

/* A row of 4 pixels, 2 times. */
typedef struct Kind {
    int depth, colour, interlace;
    unsigned char row[32];
    /* The levels of red, green, blue and alpha that they are. */
    double levels[4][4];
} Kind;

static void bytes_append(png_structp png, png_bytep bytes, size_t size) {
    text_append(png_get_io_ptr(png), bytes, size);
}

static void bytes_flush(png_structp png) {
    (void)png;
}

/* `gamma` is that of a gAMA chunk; 0 is none. */
static Text kind_write(const Kind *kind, double gamma) {
    Text file = {0};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png))) fail_msg("libpng");
    png_set_write_fn(png, &file, bytes_append, bytes_flush);
    png_set_IHDR(png, info, 4, 2, kind->depth, kind->colour, kind->interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (kind->colour == PNG_COLOR_TYPE_PALETTE)
        png_set_PLTE(png, info, (png_color[]){{10, 20, 30}, {40, 50, 60}, {255, 0, 1}, {7, 7, 7}}, 4);
    if (gamma > 0) png_set_gAMA(png, info, gamma);
    png_write_info(png, info);
    png_byte row[32];
    memcpy(row, kind->row, sizeof row);
    png_write_image(png, (png_bytep[]){row, row});
    png_write_end(png, NULL);
    png_destroy_write_struct(&png, &info);
    return file;
}

static const Kind kinds[] = {
    {8,
     PNG_COLOR_TYPE_RGB,
     PNG_INTERLACE_NONE,
     {0, 1, 2, 10, 128, 255, 9, 8, 7, 200, 100, 50},
     {{0, 1, 2, 255}, {10, 128, 255, 255}, {9, 8, 7, 255}, {200, 100, 50, 255}}},
    {8,
     PNG_COLOR_TYPE_RGB,
     PNG_INTERLACE_ADAM7,
     {0, 1, 2, 10, 128, 255, 9, 8, 7, 200, 100, 50},
     {{0, 1, 2, 255}, {10, 128, 255, 255}, {9, 8, 7, 255}, {200, 100, 50, 255}}},
    {8,
     PNG_COLOR_TYPE_RGB_ALPHA,
     PNG_INTERLACE_NONE,
     {0, 1, 2, 3, 4, 5, 6, 0, 7, 8, 9, 255, 1, 1, 1, 51},
     {{0, 1, 2, 3}, {4, 5, 6, 0}, {7, 8, 9, 255}, {1, 1, 1, 51}}},
    {8,
     PNG_COLOR_TYPE_GRAY,
     PNG_INTERLACE_NONE,
     {0, 255, 17, 99},
     {{0, 0, 0, 255}, {255, 255, 255, 255}, {17, 17, 17, 255}, {99, 99, 99, 255}}},
    {8,
     PNG_COLOR_TYPE_GRAY_ALPHA,
     PNG_INTERLACE_NONE,
     {0, 1, 255, 2, 17, 3, 99, 4},
     {{0, 0, 0, 1}, {255, 255, 255, 2}, {17, 17, 17, 3}, {99, 99, 99, 4}}},
    {1,
     PNG_COLOR_TYPE_GRAY,
     PNG_INTERLACE_NONE,
     {0xa0},
     {{255, 255, 255, 255}, {0, 0, 0, 255}, {255, 255, 255, 255}, {0, 0, 0, 255}}},
    {2,
     PNG_COLOR_TYPE_PALETTE,
     PNG_INTERLACE_NONE,
     {0x1b},
     {{10, 20, 30, 255}, {40, 50, 60, 255}, {255, 0, 1, 255}, {7, 7, 7, 255}}},
    {16,
     PNG_COLOR_TYPE_GRAY,
     PNG_INTERLACE_NONE,
     {0, 0, 255, 255, 0x80, 0, 0, 1},
     {{0, 0, 0, 255},
      {255, 255, 255, 255},
      {32768 / 257.0, 32768 / 257.0, 32768 / 257.0, 255},
      {1 / 257.0, 1 / 257.0, 1 / 257.0, 255}}},
};

static void test_png_kinds(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        Error error;
        Image image;
        Text file = kind_write(&kinds[k], 1 / 2.2), said = {0};
        if (!png_decode(&image, "x", &file, &(ImageReadParams){.said = &said}, &error))
            fail_msg("%s", error.text);
        assert_true(image.shown);
        assert_int_equal(image.width, 4);
        assert_int_equal(image.height, 2);
        for (int i = 0; i < 32; i++) {
            double level = kinds[k].levels[i / 4 % 4][i % 4], value = (double)image.rgba[i];
            double read = i % 4 == 3 ? 255 * value : tone_level(TONE_NONE, 1, value);
            if (!(fabs(read - level) < 1e-4))
                fail_msg("kind %zu, value %d: %g instead of %g", k, i, read, level);
        }
        assert_non_null(
            strstr(text_string(&said), kinds[k].depth == 16 ? "PNG of 16 bits" : "PNG of 8 bits"));
        image_free(&image);
        text_free(&file);
        text_free(&said);
    }
}

static void test_png_gamma(void **state) {
    (void)state;
    Error error;
    Image image;
    Text file = kind_write(&kinds[0], 1);
    assert_false(png_decode(&image, "x", &file, NULL, &error));
    assert_string_equal(error.text, "x: PNG with the gamma 1: only sRGB's can be read");
    assert_int_equal(error.status, STATUS_FAILURE);
    text_free(&file);
}

static bool survives(const char *bytes, size_t size) {
    Error error;
    Image image;
    /* Its own block, so that a sanitizer sees what is read past its end. */
    Text copy = {.data = memory_get(size + 1, 1), .size = size};
    memcpy(copy.data, bytes, size);
    bool read = png_decode(&image, "x", &copy, NULL, &error);
    if (!read) {
        assert_null(image.rgba);
        assert_int_equal(error.status, STATUS_FAILURE);
        assert_ptr_equal(strstr(error.text, "x: "), error.text);
        assert_null(strchr(error.text, '\n'));
    }
    image_free(&image);
    text_free(&copy);
    return read;
}

static void test_png_broken(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        Text file = kind_write(&kinds[k], 0);
        assert_true(survives(file.data, file.size));
        for (size_t size = 0; size < file.size; size++) assert_false(survives(file.data, size));
        for (size_t at = 0; at < 8 * file.size; at++) {
            file.data[at / 8] = (char)(file.data[at / 8] ^ 1 << at % 8);
            survives(file.data, file.size);
            file.data[at / 8] = (char)(file.data[at / 8] ^ 1 << at % 8);
        }
        text_free(&file);
    }
}

static void test_png_metadata(void **state) {
    (void)state;
    Error error;
    AttributeList list = {0};
    Text value = {0};
    const char *path = support_path("a.png");
    Image image = image_create(2, 2);
    attribute_add(&list, "magichour.seed", "12");
    attribute_add(&list, "magichour.exposure", "-0.5");
    assert_true(image_write(&image, path, &(ImageWriteParams){.attributes = &list}, &error));
    Text file = {0};
    assert_true(file_read(path, STATUS_FAILURE, &file, &error));
    assert_true(png_attribute(&file, "magichour.exposure", &value));
    assert_string_equal(text_string(&value), "-0.5");
    assert_true(image_attribute(&file, "magichour.seed", &value));
    assert_string_equal(text_string(&value), "-0.512");
    assert_false(png_attribute(&file, "magichour.see", &value));
    assert_false(png_attribute(&(Text){0}, "magichour.seed", &value));
    text_free(&file);
    text_free(&value);
    attribute_list_free(&list);
    image_free(&image);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_png_kinds),
        cmocka_unit_test(test_png_gamma),
        cmocka_unit_test(test_png_broken),
        cmocka_unit_test(test_png_metadata),
    };
    return cmocka_run_group_tests_name("png_read", tests, support_folder, support_clean);
}
