/* Pictures in files, and how files are replaced. */
#include "support.h"

#include "base/file.h"
#include "base/memory.h"
#include "image/codec.h"
#include "image/format.h"

#include <dirent.h>
#include <fcntl.h>
#include <math.h>
#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static char folder[512];

static int folder_make(void **state) {
    (void)state;
    const char *base = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%s/test_image_XXXXXX", base && *base ? base : "/tmp");
    return mkdtemp(folder) ? 0 : -1;
}

/* Removes all that a test left, and the folder. */
static int folder_remove(void **state) {
    (void)state;
    DIR *entries = opendir(folder);
    if (!entries) return -1;
    for (struct dirent *entry; (entry = readdir(entries));) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        char path[1024];
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        remove(path);
    }
    closedir(entries);
    return rmdir(folder);
}

static int folder_count(void) {
    DIR *entries = opendir(folder);
    assert_non_null(entries);
    int count = -2; /* . and .. */
    while (readdir(entries)) count++;
    closedir(entries);
    return count;
}

/* A path in the test's folder; good until the fourth call after it. */
static const char *in_folder(const char *name) {
    static char paths[4][1024];
    static int next;
    char *path = paths[next++ % 4];
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    return path;
}

static void assert_starts_with(const char *text, const char *start) {
    if (strncmp(text, start, strlen(start)) != 0) fail_msg("'%s' does not start with '%s'", text, start);
    assert_null(strchr(text, '\n'));
}

static const ImageWriteParams plain = {0};

static const float awkward[] = {0.0F,     -0.0F,    1.0F,      -3.5F, 1e-42F, 3.4e38F,
                                -3.4e38F, INFINITY, -INFINITY, NAN,   0.1F};

static Image awkward_image(int width, int height) {
    Image image = image_create(width, height);
    for (int i = 0; i < 4 * width * height; i++) {
        image.rgba[i] = i % 3 ? awkward[(size_t)i % (sizeof awkward / sizeof *awkward)] : (float)i * 0.37F;
    }
    return image;
}

static void round_trip(const char *name, int width, int height, bool has_alpha) {
    Error error;
    Image written = awkward_image(width, height), read;
    if (!has_alpha) {
        for (int i = 0; i < width * height; i++) written.rgba[4 * i + 3] = 1;
    }
    const char *path = in_folder(name);
    assert_true(image_write(&written, path, &plain, &error));
    assert_true(image_read(&read, path, &error));
    assert_int_equal(read.width, width);
    assert_int_equal(read.height, height);
    assert_memory_equal(read.rgba, written.rgba, (size_t)width * (size_t)height * 4 * sizeof(float));
    image_free(&written);
    image_free(&read);
}

static void test_round_trips(void **state) {
    (void)state;
    static const int sizes[][2] = {{1, 1}, {3, 5}, {5, 3}, {1, 40}, {40, 1}, {67, 33}, {16, 16}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        round_trip("a.exr", sizes[i][0], sizes[i][1], true);
        round_trip("a.PFM", sizes[i][0], sizes[i][1], false);
    }
    assert_int_equal(folder_count(), 2);
}

static bool text_contains(const Text *text, const char *bytes, size_t size) {
    for (size_t i = 0; i + size <= text->size; i++) {
        if (memcmp(text->data + i, bytes, size) == 0) return true;
    }
    return false;
}

static void test_attributes(void **state) {
    (void)state;
    Error error;
    AttributeList list = {0};
    attribute_add(&list, "magichour.seed", "%d", 12345);
    attribute_add(&list, "magichour.empty", "%s", "");
    attribute_add(&list, "magichour.a_name_of_more_than_31_bytes", "long");
    for (int i = 0; i < 100; i++) attribute_add(&list, "magichour.again", "%d", i);
    ImageWriteParams params = {.attributes = &list};
    Image image = awkward_image(7, 3), read;

    assert_true(image_write(&image, in_folder("a.exr"), &params, &error));
    assert_true(image_read(&read, in_folder("a.exr"), &error));
    image_free(&read);
    Text file = {0};
    assert_true(file_read(in_folder("a.exr"), STATUS_FAILURE, &file, &error));
    static const char seed[] = "magichour.seed\0string\0\5\0\0\00012345";
    assert_true(text_contains(&file, seed, sizeof seed - 1));
    static const char length[] = "magichour.a_name_of_more_than_31_bytes\0string\0\4\0\0\0long";
    assert_true(text_contains(&file, length, sizeof length - 1));
    text_free(&file);

    assert_true(png_encode(&image, &params, &file, &error));
    assert_true(text_contains(&file, "iTXtmagichour.seed\0\0\0\0\00012345", 28));
    text_free(&file);
    attribute_list_free(&list);
    assert_int_equal(list.count, 0);
    image_free(&image);
}

static void test_paths(void **state) {
    (void)state;
    Error error;
    assert_true(image_check_target("src/../c.EXR", NULL, &error));
    assert_true(image_check_target("c.Png", NULL, &error));
    assert_true(image_check_target("/dev/null", NULL, &error));
    static const char *const bad[] = {"a.exr/c", "c.jpg", "c", "", ".png", "c.exr.", "a.png/", "-"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(image_check_target(bad[i], NULL, &error));
        assert_int_equal(error.status, STATUS_USAGE);
        assert_starts_with(error.text, bad[i]);
        assert_non_null(strstr(error.text, ".exr, .png"));
    }
}

static void test_unreadable(void **state) {
    (void)state;
    Error error;
    Image image;
    assert_false(image_read(&image, in_folder("none.exr"), &error));
    assert_starts_with(error.text, in_folder("none.exr"));
    assert_int_equal(error.status, STATUS_FAILURE);
    assert_null(image.rgba);
    assert_false(image_read(&image, folder, &error));
    static const char *const others[] = {"", "P", "P6\n1 1\n255\n\1\2\3", "\x76\x2f\x31"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        assert_true(file_replace(in_folder("a"), others[i], strlen(others[i]), &error));
        assert_false(image_read(&image, in_folder("a"), &error));
        assert_starts_with(error.text, in_folder("a"));
    }
}

/* Any bytes give a picture or an error of one line that names the path. */
static bool survives(const Text *file, bool exr) {
    Error error;
    Image image;
    bool read = exr ? exr_decode(&image, "x", file, NULL, &error) : pfm_decode(&image, "x", file, &error);
    if (read) {
        assert_non_null(image.rgba);
    } else {
        assert_null(image.rgba);
        assert_int_equal(error.status, STATUS_FAILURE);
        assert_starts_with(error.text, "x: ");
    }
    image_free(&image);
    return read;
}

static void corrupt(const Text *file, bool exr) {
    for (size_t size = 0; size < file->size; size++) {
        Text cut = {.size = size};
        cut.data =
            memory_get(size + 1, 1); /* its own block, so that a sanitizer sees what is read past its end */
        memcpy(cut.data, file->data, size);
        assert_false(survives(&cut, exr));
        text_free(&cut);
    }
    static const unsigned char flips[] = {0x01, 0x80, 0xff, 0x20};
    for (size_t at = 0; at < file->size; at++) {
        for (size_t i = 0; i < sizeof flips; i++) {
            file->data[at] = (char)(file->data[at] ^ flips[i]);
            survives(file, exr);
            file->data[at] = (char)(file->data[at] ^ flips[i]);
        }
    }
    assert_true(survives(file, exr));
}

static void test_corrupt(void **state) {
    (void)state;
    Error error;
    Text file = {0};
    Image image = image_create(9, 21); /* two chunks */
    for (int i = 0; i < 4 * 9 * 21; i++) image.rgba[i] = (float)(i % 7);
    assert_true(exr_encode(&image, &plain, &file, &error));
    corrupt(&file, true);
    text_free(&file);
    pfm_encode(&image, &file);
    corrupt(&file, false);
    text_free(&file);
    image_free(&image);
}

static Text pfm_of(const char *header, const void *pixels, size_t size) {
    Text file = {0};
    text_append(&file, header, strlen(header));
    text_append(&file, pixels, size);
    return file;
}

static void test_pfm_kinds(void **state) {
    (void)state;
    Error error;
    Image image;
    /* 1.0 and 2.0, big-endian and grey; the first row of the file is the lowest. */
    Text file = pfm_of("Pf\n1 2\n1.0\n", "\x3f\x80\0\0\x40\0\0\0", 8);
    assert_true(pfm_decode(&image, "x", &file, &error));
    static const float grey[] = {2, 2, 2, 1, 1, 1, 1, 1};
    assert_memory_equal(image.rgba, grey, sizeof grey);
    image_free(&image);
    text_free(&file);

    file = pfm_of("PF 1 1 -2 ", "\0\0\x80\x3f\0\0\0\x40\0\0\0\xbf", 12);
    assert_true(pfm_decode(&image, "x", &file, &error));
    static const float scaled[] = {2, 4, -1, 1};
    assert_memory_equal(image.rgba, scaled, sizeof scaled);
    image_free(&image);
    text_free(&file);

    static const char *const bad[] = {"PF\n1 1\n0\n",          "PF\n0 1\n-1\n",  "PF\n-1 1\n-1\n",
                                      "PF\n1\n-1\n",           "PG\n1 1\n-1\n",  "PF\n1 1\nnan\n",
                                      "PF\n\n1 1\n-1\n",       "PF\n1 2\n-1\n",  "PF\n65537 1\n-1\n",
                                      "PF\n65536 65536\n-1\n", "PF\n1 1\n-1\r\n"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        file = pfm_of(bad[i], "0123456789ab", 12);
        assert_false(survives(&file, false));
        text_free(&file);
    }
}

/* The 8-bit picture that libpng reads back from what png_encode makes; to be freed. */
static unsigned char *png_bytes(const Image *image, const ImageWriteParams *params) {
    Error error;
    Text file = {0};
    assert_true(png_encode(image, params, &file, &error));
    png_image png = {.version = PNG_IMAGE_VERSION};
    assert_int_not_equal(png_image_begin_read_from_memory(&png, file.data, file.size), 0);
    assert_int_equal(png.width, image->width);
    assert_int_equal(png.height, image->height);
    png.format = PNG_FORMAT_RGB;
    unsigned char *bytes = memory_get(PNG_IMAGE_SIZE(png), 1);
    assert_int_not_equal(png_image_finish_read(&png, NULL, bytes, 0, NULL), 0);
    text_free(&file);
    return bytes;
}

static void test_png_extremes(void **state) {
    (void)state;
    static const struct {
        float value;
        int byte;
    } cases[] = {{0, 0},          {-0.0F, 0},     {1, 255},       {-1, 0}, {NAN, 0},
                 {INFINITY, 255}, {-INFINITY, 0}, {3.4e38F, 255}, {2, 255}};
    enum { COUNT = sizeof cases / sizeof *cases };
    Image image = image_create(COUNT, 64);
    for (int i = 0; i < COUNT * 64; i++) {
        for (int c = 0; c < 4; c++) image.rgba[4 * i + c] = cases[i % COUNT].value;
    }
    for (int tone = 0; tone < 2; tone++) {
        unsigned char *bytes = png_bytes(&image, &(ImageWriteParams){.tone = tone ? TONE_NONE : TONE_AUTHOR});
        for (int i = 0; i < 3 * COUNT * 64; i++) {
            float value = cases[i / 3 % COUNT].value; /* at 1 and 2, the author's curve is below 1 */
            if (tone || (value != 1 && value != 2)) assert_int_equal(bytes[i], cases[i / 3 % COUNT].byte);
        }
        free(bytes);
    }
    image_free(&image);
}

static double srgb_exact(double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055;
}

/* The mean of a dithered patch is the exact value: 3 * 128^2 bytes, so 0.0023 is one standard deviation at
 * most. It is what the tone curve says, too. */
static void assert_patch_mean(float radiance, ImageWriteParams params, double shown) {
    enum { SIDE = 128 };
    Image image = image_create(SIDE, SIDE);
    for (int i = 0; i < 4 * SIDE * SIDE; i++) image.rgba[i] = radiance;
    unsigned char *bytes = png_bytes(&image, &params);
    double sum = 0, exact = 255 * srgb_exact(shown);
    assert_true(fabs(tone_level(params.tone, exp2(params.exposure_ev), (double)radiance) - exact) < 1e-9);
    for (int i = 0; i < 3 * SIDE * SIDE; i++) {
        assert_true(fabs(bytes[i] - exact) < 1);
        sum += bytes[i];
    }
    assert_true(fabs(sum / (3 * SIDE * SIDE) - exact) < 0.01);
    free(bytes);
    image_free(&image);
}

static void test_png_means(void **state) {
    (void)state;
    static const float values[] = {0.001F, 0.01F, 0.18F, 0.5F, 0.97F};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        double x = (double)values[i];
        assert_patch_mean(values[i], (ImageWriteParams){.tone = TONE_NONE}, x);
        assert_patch_mean(values[i] / 8, (ImageWriteParams){.tone = TONE_NONE, .exposure_ev = 3}, x);
        double curve = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
        assert_patch_mean(values[i], (ImageWriteParams){.tone = TONE_AUTHOR}, curve);
    }
}

/* Neither rows nor channels share their dither, and it is the same each time. */
static void test_png_dither(void **state) {
    (void)state;
    Image image = image_create(64, 64);
    for (int i = 0; i < 4 * 64 * 64; i++) image.rgba[i] = 0.2F;
    unsigned char *bytes = png_bytes(&image, &plain), *again = png_bytes(&image, &plain);
    assert_memory_equal(bytes, again, 3 * 64 * 64);
    assert_memory_not_equal(bytes, bytes + 3L * 64, 3 * 64);
    int coloured = 0;
    for (int i = 0; i < 64 * 64; i++) coloured += bytes[3 * i] != bytes[3 * i + 1];
    assert_true(coloured > 64);
    free(bytes);
    free(again);
    image_free(&image);
}

static void assert_file_is(const char *path, const char *content) {
    Error error;
    Text file = {0};
    assert_true(file_read(path, STATUS_FAILURE, &file, &error));
    assert_string_equal(text_string(&file), content);
    text_free(&file);
}

static void test_replace_failing(void **state) {
    (void)state;
    Error error;
    const char *path = in_folder("a.exr");
    assert_true(file_replace(path, "old", 3, &error));
    assert_int_equal(chmod(path, 0640), 0);

    /* The disk is "full" after 4 KiB. */
    struct rlimit limit, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
    small = (struct rlimit){4096, limit.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    Image image = awkward_image(100, 100);
    bool replaced = image_write(&image, path, &plain, &error);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
    signal(SIGXFSZ, SIG_DFL);
    assert_false(replaced);
    assert_int_equal(error.status, STATUS_OUTPUT);
    assert_starts_with(error.text, path);
    assert_file_is(path, "old");
    assert_int_equal(folder_count(), 1);

    assert_true(image_write(&image, path, &plain, &error));
    struct stat status;
    assert_int_equal(stat(path, &status), 0);
    assert_int_equal(status.st_mode & 07777, 0640);
    assert_int_equal(folder_count(), 1);
    image_free(&image);
}

/* Killed while it replaces the file again and again: what is there is whole, the one or the other. */
static void test_replace_killed(void **state) {
    (void)state;
    Error error;
    enum { SIZE = 1 << 20 };
    const char *path = in_folder("a");
    char *bytes = memory_get(SIZE, 1);
    assert_true(file_replace(path, bytes, SIZE, &error));
    pid_t child = fork();
    assert_true(child >= 0);
    /* The child goes on until it is killed. */
    if (child == 0) {
        for (int i = 1;; i++) {
            memset(bytes, i, SIZE);
            if (!file_replace(path, bytes, SIZE, &error)) _exit(1);
        }
    }
    usleep(50000);
    kill(child, SIGKILL);
    waitpid(child, NULL, 0);
    Text file = {0};
    assert_true(file_read(path, STATUS_FAILURE, &file, &error));
    assert_int_equal(file.size, SIZE);
    memset(bytes, file.data[0], SIZE);
    assert_memory_equal(file.data, bytes, SIZE);
    text_free(&file);
    free(bytes);
}

static void test_replace_targets(void **state) {
    (void)state;
    Error error;
    const char *path = in_folder("a.pfm"), *link = in_folder("link.pfm");
    assert_true(file_replace(path, "old", 3, &error));
    assert_int_equal(symlink("a.pfm", link), 0);
    assert_true(file_replace(link, "new", 3, &error));
    struct stat status;
    assert_int_equal(lstat(link, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    assert_file_is(path, "new");
    assert_int_equal(folder_count(), 2);

    /* A link to a file that is not there yet makes that file. */
    const char *dangling = in_folder("dangling.pfm");
    assert_int_equal(symlink("made.pfm", dangling), 0);
    assert_true(file_replace(dangling, "made", 4, &error));
    assert_int_equal(lstat(dangling, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    assert_file_is(in_folder("made.pfm"), "made");
    assert_int_equal(unlink(dangling), 0);
    assert_int_equal(unlink(in_folder("made.pfm")), 0);

    Image image = awkward_image(4, 4);
    assert_true(image_write(&image, "/dev/null", &plain, &error));
    const char *const bad[] = {"/dev/full", folder, in_folder("none/a.png")};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(image_write(&image, bad[i], &plain, &error));
        assert_int_equal(error.status, STATUS_OUTPUT);
        assert_starts_with(error.text, bad[i]);
    }
    assert_int_equal(folder_count(), 2);

    Image nothing = {0};
    assert_false(image_write(&nothing, in_folder("b.png"), &plain, &error));
    assert_starts_with(error.text, in_folder("b.png"));
    assert_false(image_write(&nothing, in_folder("b.exr"), &plain, &error));
    assert_starts_with(error.text, in_folder("b.exr"));
    assert_int_equal(folder_count(), 2);
    image_free(&image);
}

#define TEST_IN_FOLDER(test) cmocka_unit_test_setup_teardown(test, folder_make, folder_remove)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST_IN_FOLDER(test_round_trips),    TEST_IN_FOLDER(test_attributes),
        cmocka_unit_test(test_paths),        TEST_IN_FOLDER(test_unreadable),
        cmocka_unit_test(test_corrupt),      cmocka_unit_test(test_pfm_kinds),
        cmocka_unit_test(test_png_extremes), cmocka_unit_test(test_png_means),
        cmocka_unit_test(test_png_dither),   TEST_IN_FOLDER(test_replace_failing),
        TEST_IN_FOLDER(test_replace_killed), TEST_IN_FOLDER(test_replace_targets),
    };
    return cmocka_run_group_tests_name("image", tests, NULL, NULL);
}
