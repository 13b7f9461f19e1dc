#include "exr_files.h"
#include "support.h"

#include <openexr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHANNELS_MOST = 16 };

/* The channels' names, cut out of `words`; how many there are. */
static int channels_split(char *words, const char *names[CHANNELS_MOST]) {
    int count = 0;
    for (char *rest = words, *name; (name = strtok_r(rest, " ", &rest));) {
        assert_true(count < CHANNELS_MOST);
        names[count++] = name;
    }
    return count;
}

static exr_attr_box2i_t box(Rectangle r) {
    exr_attr_box2i_t box;
    if (!r.width) r = (Rectangle){0, 0, 4, 3};
    box.min.x = r.x;
    box.min.y = r.y;
    box.max.x = r.x + r.width - 1;
    box.max.y = r.y + r.height - 1;
    return box;
}

static void part_declare(exr_context_t context, const ExrFile *file, int p) {
    exr_attr_box2i_t data = box(file->data), display = box(file->display);
    const exr_attr_v2f_t centre = {.x = 0};
    const exr_attr_chromaticities_t aces = {0.7347F, 0.2653F, 0, 1, 0.0001F, -0.077F, 0.32168F, 0.33767F};
    const char *names[CHANNELS_MOST];
    char words[256];
    int part;
    snprintf(words, sizeof words, "%s", file->parts[p].channels);
    assert_int_equal(exr_add_part(context, file->parts[p].name, EXR_STORAGE_SCANLINE, &part),
                     EXR_ERR_SUCCESS);
    assert_int_equal(exr_initialize_required_attr(context, part, &display, &data, 1, &centre, 1,
                                                  EXR_LINEORDER_INCREASING_Y, EXR_COMPRESSION_ZIP),
                     EXR_ERR_SUCCESS);
    if (file->aces)
        assert_int_equal(exr_attr_set_chromaticities(context, part, "chromaticities", &aces),
                         EXR_ERR_SUCCESS);
    int count = channels_split(words, names);
    for (int c = 0; c < count; c++)
        assert_int_equal(
            exr_add_channel(context, part, names[c], EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LINEAR, 1, 1),
            EXR_ERR_SUCCESS);
}

static void chunk_write(exr_context_t context, const ExrFile *file, int p, int y, float *pixels) {
    exr_chunk_info_t chunk;
    exr_encode_pipeline_t pipeline = EXR_ENCODE_PIPELINE_INITIALIZER;
    const char *names[CHANNELS_MOST];
    char words[256];
    snprintf(words, sizeof words, "%s", file->parts[p].channels);
    int count = channels_split(words, names);
    assert_int_equal(exr_write_scanline_chunk_info(context, p, y, &chunk), EXR_ERR_SUCCESS);
    assert_int_equal(exr_encoding_initialize(context, p, &chunk, &pipeline), EXR_ERR_SUCCESS);
    for (int c = 0; c < count; c++) {
        /* Strides of 0 are not allowed, so each channel has a chunk of pixels of its own. */
        float *values = pixels + (size_t)c * (size_t)chunk.width * (size_t)chunk.height;
        for (int i = 0; i < chunk.width * chunk.height; i++)
            values[i] = file->values ? file->values[c] : (float)(100 * p + c + 1);
        for (int i = 0; i < pipeline.channel_count; i++) {
            exr_coding_channel_info_t *channel = &pipeline.channels[i];
            if (strcmp(channel->channel_name, names[c]) != 0) continue;
            channel->user_pixel_stride = sizeof(float);
            channel->user_line_stride = chunk.width * (int32_t)sizeof(float);
            channel->encode_from_ptr = (const uint8_t *)values;
        }
    }
    assert_int_equal(exr_encoding_choose_default_routines(context, p, &pipeline), EXR_ERR_SUCCESS);
    assert_int_equal(exr_encoding_run(context, p, &pipeline), EXR_ERR_SUCCESS);
    exr_encoding_destroy(context, &pipeline);
}

void exr_file_write(const char *path, const ExrFile *file) {
    exr_context_t context = NULL;
    exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
    assert_int_equal(exr_start_write(&context, path, EXR_WRITE_FILE_DIRECTLY, &settings), EXR_ERR_SUCCESS);
    int parts = 0;
    while (parts < 4 && file->parts[parts].channels) part_declare(context, file, parts++);
    assert_int_equal(exr_write_header(context), EXR_ERR_SUCCESS);
    for (int p = 0; p < parts; p++) {
        int32_t lines = 0;
        exr_attr_box2i_t data;
        assert_int_equal(exr_get_scanlines_per_chunk(context, p, &lines), EXR_ERR_SUCCESS);
        assert_int_equal(exr_get_data_window(context, p, &data), EXR_ERR_SUCCESS);
        float *pixels =
            calloc((size_t)(CHANNELS_MOST * lines * (data.max.x - data.min.x + 1)), sizeof *pixels);
        assert_non_null(pixels);
        for (int y = data.min.y; y <= data.max.y; y += lines) chunk_write(context, file, p, y, pixels);
        free(pixels);
    }
    assert_int_equal(exr_finish(&context), EXR_ERR_SUCCESS);
}
