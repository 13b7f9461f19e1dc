/* Files that are broken at random: readers must refuse them with a place, or read them, and nothing else. The
 * mutations are the same in every run; the sanitizers watch what is read past an end. */
#include "scene_list.h"
#include "support.h"

#include "base/file.h"
#include "base/memory.h"
#include "cmd/sky_rows.h"
#include "image/codec.h"
#include "scene/scene.h"
#include "scene/sphere_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t dice_state;

static size_t dice(size_t sides) {
    dice_state = dice_state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (size_t)(dice_state >> 33) % sides;
}

/* What breaks readers of text: numbers past ranges, words where numbers are due, quotes without end, bytes
 * that are no text. */
static const char *const words[] = {"nan",
                                    "-1",
                                    "1e999",
                                    "0x1p3",
                                    "99999999999999999999",
                                    "\"",
                                    "//@ ",
                                    "\n",
                                    "\r",
                                    "\t",
                                    ",",
                                    "#",
                                    "uniform float x; //@ slider 1 min 2 max 0\n",
                                    "//@ sun\n",
                                    "\xff\xfe",
                                    "\xef\xbb\xbf",
                                    "min",
                                    "preset a sun.elevation 1e5 ",
                                    "PF",
                                    "-",
                                    "."};

/* A copy in a block of its own size, with one to four changes. */
static Text mutate(const Text *file) {
    Text out = {0};
    text_append(&out, file->data, file->size);
    for (size_t changes = 1 + dice(4); changes > 0 && out.size > 0; changes--) {
        size_t at = dice(out.size), length = dice(out.size - at < 40 ? out.size - at + 1 : 40);
        Text next = {0};
        text_append(&next, out.data, at);
        switch (dice(8)) {
        case 0:
        case 1:
        case 2: /* a byte becomes another */
            text_append(&next, &(char){(char)dice(256)}, 1);
            text_append(&next, out.data + at + 1, out.size - at - 1);
            break;
        case 3: /* some are lost */
            text_append(&next, out.data + at + length, out.size - at - length);
            break;
        case 4: /* some stand there twice */
            text_append(&next, out.data + at, length);
            text_append(&next, out.data + at, out.size - at);
            break;
        case 5: /* a word too much */
        case 6: {
            const char *word = words[dice(sizeof words / sizeof *words)];
            text_append(&next, word, strlen(word));
            text_append(&next, out.data + at, out.size - at);
            break;
        }
        default: /* the rest is missing */
            break;
        }
        text_free(&out);
        out = next;
    }
    /* To the byte, so that the sanitizer sees what is read past the end. */
    Text exact = {.data = memory_get(out.size + 1, 1), .size = out.size};
    if (out.size) memcpy(exact.data, out.data, out.size);
    text_free(&out);
    return exact;
}

static Text read_file(const char *path) {
    Text text = {0};
    Error error;
    if (!file_read(path, STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    return text;
}

/* Without file_replace(), which waits for the disk. */
static const char *write_file(const char *name, const Text *text) {
    const char *path = support_path(name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text->data, 1, text->size, file), text->size);
    fclose(file);
    return path;
}

/* An error names the file, and its words fit one line. */
static void expect_place(const char *path, const Error *error) {
    if (strncmp(error->text, path, strlen(path)) != 0 || error->text[strlen(path)] != ':')
        fail_msg("an error without its file: %s", error->text);
}

static void test_pictures(void **state) {
    (void)state;
    enum { TRIES = 3000 };
    ImageWriteParams params = {0};
    Error error;
    int refused[2] = {0};
    Image image = image_create(9, 21);
    for (int i = 0; i < 4 * 9 * 21; i++) image.rgba[i] = (float)(i % 7);
    dice_state = 1;
    for (int kind = 0; kind < 2; kind++) {
        Text file = {0};
        if (kind)
            pfm_encode(&image, &file);
        else
            assert_true(exr_encode(&image, &params, &file, &error));
        for (int i = 0; i < TRIES; i++) {
            Text broken = mutate(&file);
            Image got;
            bool ok =
                kind ? pfm_decode(&got, "x", &broken, &error) : exr_decode(&got, "x", &broken, NULL, &error);
            if (ok)
                assert_true(got.width > 0 && got.height > 0 && got.rgba);
            else
                expect_place("x", &error);
            refused[kind] += !ok;
            image_free(&got);
            text_free(&broken);
        }
        text_free(&file);
    }
    print_message("of %d pictures each, refused: %d EXR, %d PFM\n", TRIES, refused[0], refused[1]);
    assert_true(refused[0] > TRIES / 4 && refused[0] < TRIES && refused[1] > TRIES / 4 && refused[1] < TRIES);
    image_free(&image);
}

static void test_spheres(void **state) {
    (void)state;
    enum { TRIES = 1500 };
    static const char rows[] =
        "# balls\nx,y,z,radius\n0,1.5,0,0.5\n-1e3,2,3,4,5,6\n\n1,2,3,1e-3\r\n7,8,9,10\n";
    Text file = {0};
    int refused = 0;
    text_append(&file, rows, strlen(rows));
    dice_state = 2;
    for (int i = 0; i < TRIES; i++) {
        Text broken = mutate(&file);
        const char *path = write_file("balls.csv", &broken);
        float *spheres = NULL;
        int count = 0;
        Error error;
        SourceStore *store = source_store_create("glsl");
        source_store_choose(store, path);
        const SourceFile *balls;
        bool ok = source_store_read(store, path, &balls, &error) &&
                  sphere_file_parse(balls, 1000, &spheres, &count, &error);
        for (int k = 0; ok && k < 4 * count; k++)
            assert_true(isfinite(spheres[k]) && fabsf(spheres[k]) <= 1e7f && (k % 4 < 3 || spheres[k] > 0));
        if (!ok) expect_place(path, &error);
        refused += !ok;
        source_store_release(store);
        if (ok) free(spheres);
        text_free(&broken);
    }
    text_free(&file);
    print_message("of %d files of spheres, %d refused\n", TRIES, refused);
    assert_true(refused > TRIES / 10 && refused < TRIES);
}

static void test_directions(void **state) {
    (void)state;
    enum { TRIES = 1500 };
    static const char rows[] =
        "# at noon\nheight_m,sun_el_deg,view_el_deg,az_deg\n1,60,45,0\n1000,-2,0.5,180,x\n2,5,90,0\n";
    Text file = {0};
    int refused = 0;
    text_append(&file, rows, strlen(rows));
    dice_state = 3;
    for (int i = 0; i < TRIES; i++) {
        Text broken = mutate(&file);
        const char *path = write_file("directions.csv", &broken);
        SkyRows read = {0};
        Error error;
        bool ok = sky_rows_read(&read, path, &error);
        for (size_t k = 0; ok && k < read.count; k++)
            assert_true(isfinite(read.rows[k].height_m) && fabs(read.rows[k].view_el_deg) <= 90);
        if (!ok) expect_place(path, &error);
        refused += !ok;
        if (ok) sky_rows_free(&read);
        text_free(&broken);
    }
    text_free(&file);
    print_message("of %d files of directions, %d refused\n", TRIES, refused);
    assert_true(refused > TRIES / 10 && refused < TRIES);
}

/* A scene that is read can be set up: its numbers are finite, and each preset can be chosen. */
static void expect_scene(const Scene *scene) {
    assert_true(scene->file->width > 0 && scene->file->height > 0);
    for (int i = 0; i < 3; i++)
        assert_true(isfinite(scene->values.camera.eye[i]) && isfinite(scene->values.camera.target[i]));
    for (int i = 0; i < scene->file->preset_count; i++) {
        Scene trial = *scene;
        Error error;
        if (!scene_choose_preset(&trial, scene->file->presets[i].name, &error)) fail_msg("%s", error.text);
    }
}

static void test_annotations(void **state) {
    (void)state;
    enum { TRIES = 120 };
    SceneList list = scene_list();
    int refused = 0;
    dice_state = 4;
    for (int s = 0; s < list.count; s++) {
        Text whole = read_file(list.paths[s]), notes = {0};
        /* The lines with annotations alone: changes elsewhere are not read here. */
        text_append(&whole, "", 0);
        for (const char *line = text_string(&whole); *line;) {
            size_t length = strcspn(line, "\n");
            const char *note = strstr(line, "//@");
            if (note && note < line + length) text_print(&notes, "%.*s\n", (int)length, line);
            line += length + (line[length] == '\n');
        }
        for (int i = 0; i < TRIES; i++) {
            Text broken = mutate(&notes);
            const char *path = write_file("broken.glsl", &broken);
            Scene scene;
            Error error;
            bool ok = scene_read(&scene, path, "glsl", &error);
            if (ok) {
                expect_scene(&scene);
                scene_destroy(&scene);
            } else {
                expect_place(path, &error);
                assert_int_equal(error.status, STATUS_SCENE);
            }
            refused += !ok;
            text_free(&broken);
        }
        text_free(&notes);
        text_free(&whole);
    }
    print_message("of %d scenes, %d refused\n", TRIES * list.count, refused);
    assert_true(refused > TRIES && refused < TRIES * list.count);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pictures),
        cmocka_unit_test(test_spheres),
        cmocka_unit_test(test_directions),
        cmocka_unit_test(test_annotations),
    };
    return cmocka_run_group_tests_name("fuzz", tests, support_folder, support_clean);
}
