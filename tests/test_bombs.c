/* Pictures that ask for far more than they have: refused before anything is taken, with both numbers. */
#include "faults.h"

#include "base/budget.h"
#include "base/file.h"
#include "image/codec.h"

#include <png.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void put(Text *file, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++) text_append(file, (char[]){(char)(value >> (8 * i))}, 1);
}

static void put_attribute(Text *file, const char *name, const char *type, size_t size) {
    text_append(file, name, strlen(name) + 1);
    text_append(file, type, strlen(type) + 1);
    put(file, size, 4);
}

/* What an EXR is to claim of itself. */
typedef struct Claims {
    /* Right and lower ends of its windows. */
    int x, y, display_x, display_y;
    int channels, attributes, parts;
    /* The sides of its tiles; 0 for lines. */
    unsigned tile;
    /* 0 none, 1 RLE, 3 ZIP, 4 PIZ, 8 DWAA. */
    int compression;
    /* How many bytes of zeros follow the headers. */
    size_t zeros;
} Claims;

static void put_window(Text *file, const char *name, int x, int y) {
    put_attribute(file, name, "box2i", 16);
    put(file, 0, 8);
    put(file, (uint64_t)x, 4);
    put(file, (uint64_t)y, 4);
}

static void put_channels(Text *file, int count) {
    static const char *const rgb[] = {"B", "G", "R"};
    Text list = {0};
    for (int i = 0; i < count; i++) {
        char name[32];
        snprintf(name, sizeof name, "%s%.0d", count == 3 ? rgb[i] : "c", count == 3 ? 0 : i + 100000);
        text_append(&list, name, strlen(name) + 1);
        put(&list, 2, 4);
        put(&list, 0, 4);
        put(&list, 1, 4);
        put(&list, 1, 4);
    }
    put_attribute(file, "channels", "chlist", list.size + 1);
    text_append(file, list.data, list.size);
    put(file, 0, 1);
    text_free(&list);
}

static void put_header(Text *file, const Claims *claims, int part) {
    put_channels(file, claims->channels ? claims->channels : 3);
    put_attribute(file, "compression", "compression", 1);
    put(file, (uint64_t)claims->compression, 1);
    put_window(file, "dataWindow", claims->x, claims->y);
    put_window(file, "displayWindow", claims->display_x ? claims->display_x : claims->x,
               claims->display_y ? claims->display_y : claims->y);
    put_attribute(file, "lineOrder", "lineOrder", 1);
    put(file, 0, 1);
    put_attribute(file, "pixelAspectRatio", "float", 4);
    put(file, 0x3f800000, 4);
    put_attribute(file, "screenWindowCenter", "v2f", 8);
    put(file, 0, 8);
    put_attribute(file, "screenWindowWidth", "float", 4);
    put(file, 0x3f800000, 4);
    if (claims->tile) {
        put_attribute(file, "tiles", "tiledesc", 9);
        put(file, claims->tile, 4);
        put(file, claims->tile, 4);
        put(file, 0, 1);
    }
    for (int i = 0; i < claims->attributes; i++) {
        char name[32];
        snprintf(name, sizeof name, "a%d", i);
        put_attribute(file, name, "int", 4);
        put(file, 0, 4);
    }
    if (claims->parts) {
        char name[32];
        const char *type = claims->tile ? "tiledimage" : "scanlineimage";
        snprintf(name, sizeof name, "part%d", part);
        put_attribute(file, "name", "string", strlen(name));
        text_append(file, name, strlen(name));
        put_attribute(file, "type", "string", strlen(type));
        text_append(file, type, strlen(type));
        put_attribute(file, "chunkCount", "int", 4);
        put(file, (uint64_t)claims->y + 1, 4);
    }
    put(file, 0, 1);
}

static const char *write_exr(const char *name, Claims claims) {
    Text file = {0};
    Error error;
    put(&file, 20000630, 4);
    put(&file, (claims.parts ? 0x1000 : claims.tile ? 0x200 : 0) | 2, 4);
    for (int part = 0; part < (claims.parts ? claims.parts : 1); part++) put_header(&file, &claims, part);
    if (claims.parts) put(&file, 0, 1);
    char *zeros = calloc(claims.zeros + 1, 1);
    text_append(&file, zeros, claims.zeros);
    free(zeros);
    if (!file_replace(support_path(name), file.data, file.size, &error)) fail_msg("%s", error.text);
    text_free(&file);
    return support_path(name);
}

static void expect_refused(const char *path, const char *part) {
    fault_expect(1, part, "compare '%s' '%s'", path, path);
}

static void test_exr_sizes(void **state) {
    (void)state;
    static const int compressions[] = {0, 1, 3, 4, 8};
    for (size_t i = 0; i < sizeof compressions / sizeof *compressions; i++) {
        const char *path = write_exr(
            "big.exr", (Claims){.x = 16383, .y = 16383, .compression = compressions[i], .zeros = 200000});
        expect_refused(path, "EXR that unpacks to 3072 MiB: at most 52");
        path = write_exr("big.exr",
                         (Claims){.x = 6143, .y = 6143, .compression = compressions[i], .zeros = 200000});
        expect_refused(path, "big.exr: the picture of 6144x6144 pixels in a file of 20");
        if (!strstr(support_err, " MiB of memory, and 268 MiB are allowed (--max-memory"))
            fail_msg("%s", support_err);
        /* A small part of a large picture. */
        path = write_exr("big.exr", (Claims){.x = 63,
                                             .y = 63,
                                             .display_x = 16383,
                                             .display_y = 16383,
                                             .compression = compressions[i],
                                             .zeros = 20000});
        expect_refused(path, "big.exr: the picture of 64x64 pixels in a file of ");
    }
    const char *path = write_exr("tiles.exr", (Claims){.x = 16383, .y = 16383, .tile = 1, .zeros = 200000});
    expect_refused(path, "the places of its 268435456 chunks take more than the");
    path = write_exr("tiles.exr",
                     (Claims){.x = 3000, .y = 3000, .tile = 3001, .compression = 3, .zeros = 20000});
    expect_refused(path, "needs 447 MiB of memory, and 257 MiB are allowed");
    path = write_exr("wide.exr",
                     (Claims){.x = 65535, .y = 0, .channels = 4000, .compression = 3, .zeros = 2000});
    expect_refused(path, "wide.exr: ");
    path = write_exr("out.exr", (Claims){.x = 70000, .y = 3, .zeros = 2000});
    expect_refused(path, "EXR with a data window of 70001x4: at most 65536x65536");
}

static void test_exr_counts(void **state) {
    (void)state;
    const char *path = write_exr("many.exr", (Claims){.x = 3, .y = 3, .channels = 40000, .zeros = 64});
    expect_refused(path, "EXR of 40000 channels: at most 4096 can be read");
    fault_expect(1, "many.exr: ", "info '%s'", path);
    path = write_exr("many.exr", (Claims){.x = 3, .y = 3, .attributes = 40000, .zeros = 64});
    expect_refused(path, "EXR of 40008 attributes: at most 4096 can be read");
    path = write_exr("many.exr", (Claims){.x = 0, .y = 0, .channels = 1, .parts = 5000, .zeros = 64});
    expect_refused(path, "at most");
    /* What is within the bounds takes no long time either. */
    path = write_exr("many.exr", (Claims){.x = 0, .y = 0, .channels = 4096, .zeros = 8 + 8 + 4 * 4096});
    expect_refused(path, "no layer is clearly the picture");
    path = write_exr("many.exr", (Claims){.x = 0, .y = 0, .attributes = 4000, .channels = 3, .zeros = 64});
    fault_expect(1, "many.exr: ", "compare '%s' '%s'", path, path);
    path = write_exr("many.exr", (Claims){.x = 0, .y = 0, .channels = 1, .parts = 370, .zeros = 64});
    expect_refused(path, "many.exr: ");
}

static void put_chunk(Text *file, const char *type, const char *data, size_t size) {
    Text body = {0};
    text_append(&body, type, 4);
    text_append(&body, data, size);
    uint32_t crc = 0xffffffff;
    for (size_t i = 0; i < body.size; i++) {
        crc ^= (unsigned char)body.data[i];
        for (int k = 0; k < 8; k++) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
    }
    for (int i = 3; i >= 0; i--) put(file, size >> (8 * i) & 0xff, 1);
    text_append(file, body.data, body.size);
    for (int i = 3; i >= 0; i--) put(file, ~crc >> (8 * i) & 0xff, 1);
    text_free(&body);
}

static const char *write_png(int width, int height, int depth, int color) {
    Text file = {0}, head = {0};
    Error error;
    text_append(&file, "\x89PNG\r\n\x1a\n", 8);
    for (int i = 3; i >= 0; i--) put(&head, (uint64_t)width >> (8 * i) & 0xff, 1);
    for (int i = 3; i >= 0; i--) put(&head, (uint64_t)height >> (8 * i) & 0xff, 1);
    put(&head, (uint64_t)depth, 1);
    put(&head, (uint64_t)color, 1);
    put(&head, 0, 3);
    put_chunk(&file, "IHDR", head.data, head.size);
    put_chunk(&file, "IDAT", "\x78\x9c\x03\x00\x00\x00\x00\x01", 8);
    put_chunk(&file, "IEND", "", 0);
    if (!file_replace(support_path("bomb.png"), file.data, file.size, &error)) fail_msg("%s", error.text);
    text_free(&file);
    text_free(&head);
    return support_path("bomb.png");
}

static void test_png(void **state) {
    (void)state;
    expect_refused(write_png(16384, 16384, 8, 2), "the picture of 16384x16384 pixels in a file of ");
    expect_refused(write_png(5000, 5000, 16, 6), "needs 573 MiB of memory, and 256 MiB are allowed");
    expect_refused(write_png(65536, 65536, 1, 0), "PNG of 65536x65536: at most 268435456 pixels can be read");
    expect_refused(write_png(2147483647, 2147483647, 1, 0), "bomb.png: ");
    /* A text that claims to be longer than the file. */
    const char *path = write_png(3, 3, 8, 2);
    assert_int_equal(
        fault_shell("head -c 33 $D/bomb.png >$D/text.png; printf '\\151\\0\\0\\0iTXtmagichour.samples' "
                    ">>$D/text.png; cat $D/bomb.png >>$D/text.png"),
        0);
    fault_expect(1, "text.png: broken PNG: it ends too early", "compare '%s' '%s'", support_path("text.png"),
                 path);
    /* It claims no more than it may, and has nothing. */
    expect_refused(write_png(3000, 3000, 8, 2), "bomb.png: broken PNG: ");
}

static void test_pfm(void **state) {
    (void)state;
    const char *path = support_write("bomb.pfm", "PF\n16384 16384\n-1\nabc");
    expect_refused(path, "truncated PFM: 3 bytes of pixels instead of 3221225472");
    path = support_write("bomb.pfm", "PF\n99999999999 16384\n-1\nabc");
    expect_refused(path, "broken PFM header");
}

/* Streams that do not end, and files that are too large. */
static void test_streams(void **state) {
    (void)state;
    const char *path = support_write("a.pfm", "Pf\n1 1\n-1\nabcd");
    char command[1024];
    assert_int_equal(fault_shell("ulimit -t 2; $M compare - $D/a.pfm </dev/zero"), 1);
    if (!strstr(support_err, "standard input: neither an EXR")) fail_msg("%s", support_err);
    assert_int_equal(
        fault_shell("ulimit -t 5; { cat $D/a.pfm; cat /dev/zero; } | $M compare - $D/a.pfm --max-memory 64M"),
        1);
    if (!strstr(support_err, "standard input: cannot be read: it has more than the 67108864 bytes"))
        fail_msg("%s", support_err);
    snprintf(command, sizeof command, "cp $D/a.pfm $D/large.pfm; truncate -s 3G $D/large.pfm");
    assert_int_equal(fault_shell("%s", command), 0);
    fault_expect(1, "it has 3221225472 bytes, and at most 1073741824 can be", "compare '%s' '%s'",
                 support_path("large.pfm"), path);
}

/* --max-memory: of pictures that are read, together, and of pictures that are drawn. */
static void test_budget(void **state) {
    (void)state;
    Error error;
    Image image = image_create(512, 512), read;
    const char *path = support_path("half.pfm");
    assert_true(image_write(&image, path, &(ImageWriteParams){0}, &error));
    image_free(&image);
    assert_int_equal(support_run("", "compare '%s' '%s' --max-memory 40M", path, path), 0);
    fault_expect(1, "the comparison needs 13 MiB of memory, and 12 MiB are allowed",
                 "compare '%s' '%s' --max-memory 20M", path, path);
    fault_expect(1, "needs 4096 KiB of memory, and 3584 KiB are allowed besides what is in use",
                 "compare '%s' '%s' --max-memory 7.5M", path, path);
    budget_set(100);
    assert_false(image_read(&read, path, &error));
    budget_set(0);
    assert_true(image_read(&read, path, &error));
    image_free(&read);
    static const char *const bad[] = {"", "M", "3", "12Q", "-5M", "nan", "1e400", "5MM", "0x10M"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        fault_expect(2, "is no size from 1M", "compare a b --max-memory '%s'", bad[i]);
    fault_expect(2, "the map needs 1536 MiB of memory, and 500 MiB are allowed",
                 "sky -o '%s' --size 8192x4096 --max-memory 500M", support_path("o.exr"));
    fault_expect(2, "the OpenGL driver needs 192 MiB of memory, and 50 MiB are allowed",
                 "render scenes/crater.glsl -o '%s' --max-memory 50M", support_path("o.exr"));
    support_expect(2, "a picture of 4096x4096 pixels needs ",
                   "render scenes/crater.glsl -o '%s' --size 4096x4096 "
                   "--max-memory 1G",
                   support_path("o.exr"));
    support_expect(0, "", "render scenes/crater.glsl -o '%s' --size 64x64 --spp 1 --quiet --max-memory 0.25G",
                   support_path("o.exr"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exr_sizes), cmocka_unit_test(test_exr_counts), cmocka_unit_test(test_png),
        cmocka_unit_test(test_pfm),       cmocka_unit_test(test_streams),    cmocka_unit_test(test_budget),
    };
    return cmocka_run_group_tests_name("bombs", tests, support_folder, support_clean);
}
