#include "image/codec.h"
#include "image/exr_stream.h"

#include <stdio.h>
#include <string.h>

/* The picture itself is the first layer. */
static int layer_count(const Image *image) {
    return 1 + image->layer_count;
}

static ImageLayer layer_get(const Image *image, int i) {
    return i ? image->layers[i - 1] : (ImageLayer){"", "RGBA", image->rgba};
}

static void channel_name(const ImageLayer *layer, size_t channel, char *name, size_t size) {
    snprintf(name, size, "%s%s%c", layer->name, *layer->name ? "." : "", layer->channels[channel]);
}

/* OpenEXR puts the channels into the order of their names, as the format wants them. */
static exr_result_t layer_declare(exr_context_t file, int part, const ImageLayer *layer) {
    exr_result_t result = EXR_ERR_SUCCESS;
    for (size_t c = 0; !result && layer->channels[c]; c++) {
        char name[64];
        channel_name(layer, c, name, sizeof name);
        result = exr_add_channel(file, part, name, EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    }
    return result;
}

static exr_attr_box2i_t box_of(Rectangle r) {
    exr_attr_box2i_t box;
    box.min.x = r.x, box.min.y = r.y;
    box.max.x = r.x + r.width - 1, box.max.y = r.y + r.height - 1;
    return box;
}

static exr_result_t header_write(exr_context_t file, const Image *image, const ImageWriteParams *params) {
    const AttributeList *attributes = params->attributes;
    int part;
    Rectangle held = image_window(image);
    exr_attr_box2i_t display = box_of((Rectangle){0, 0, image->width, image->height}), data = box_of(held);
    exr_attr_v2f_t centre;
    memset(&centre, 0, sizeof centre);
    exr_result_t result = exr_add_part(file, NULL, EXR_STORAGE_SCANLINE, &part);
    if (!result) {
        result = exr_initialize_required_attr(file, part, &display, &data, 1, &centre, 1,
                                              EXR_LINEORDER_INCREASING_Y, EXR_COMPRESSION_ZIP);
    }
    for (int i = 0; !result && i < layer_count(image); i++) {
        ImageLayer layer = layer_get(image, i);
        result = layer_declare(file, part, &layer);
    }
    if (!result && params->latlong) result = exr_attr_set_envmap(file, part, "envmap", EXR_ENVMAP_LATLONG);
    for (int i = 0; !result && attributes && i < attributes->count; i++) {
        const Attribute *attribute = &attributes->items[i];
        /* Readers from before OpenEXR 1.7 know names of up to 31 bytes only, so longer ones are only allowed
         * where there is one. */
        if (strlen(attribute->name) > 31) result = exr_set_longname_support(file, 1);
        if (!result) result = exr_attr_set_string(file, part, attribute->name, attribute->value);
    }
    return result ? result : exr_write_header(file);
}

/* Points the channel at its numbers of the layer from column x of row y on, if it is one of the layer's. */
static void channel_point(exr_coding_channel_info_t *channel, const ImageLayer *layer, int width, int x,
                          int y) {
    size_t channels = strlen(layer->channels);
    for (size_t c = 0; c < channels; c++) {
        char name[64];
        channel_name(layer, c, name, sizeof name);
        if (strcmp(name, channel->channel_name) != 0) continue;
        channel->user_pixel_stride = (int32_t)(channels * sizeof(float));
        channel->user_line_stride = width * channel->user_pixel_stride;
        channel->encode_from_ptr =
            (const uint8_t *)(layer->data + channels * ((size_t)y * (size_t)width + (size_t)x) + c);
    }
}

static exr_result_t chunk_write(exr_context_t file, const Image *image, int y) {
    exr_chunk_info_t chunk;
    exr_result_t result = exr_write_scanline_chunk_info(file, 0, y, &chunk);
    if (result) return result;
    exr_encode_pipeline_t pipeline = EXR_ENCODE_PIPELINE_INITIALIZER;
    result = exr_encoding_initialize(file, 0, &chunk, &pipeline);
    if (!result) {
        for (int i = 0; i < layer_count(image); i++) {
            ImageLayer layer = layer_get(image, i);
            for (int c = 0; c < pipeline.channel_count; c++)
                channel_point(&pipeline.channels[c], &layer, image->width, image_window(image).x, y);
        }
        result = exr_encoding_choose_default_routines(file, 0, &pipeline);
    }
    if (!result) result = exr_encoding_run(file, 0, &pipeline);
    exr_encoding_destroy(file, &pipeline);
    return result;
}

bool exr_encode(const Image *image, const ImageWriteParams *params, Text *out, Error *error) {
    ExrStream stream = {.out = out, .start = out->size};
    exr_context_initializer_t settings = exr_settings(&stream);
    exr_context_t file = NULL;
    exr_result_t result = exr_start_write(&file, "EXR", EXR_WRITE_FILE_DIRECTLY, &settings);
    if (!result) result = header_write(file, image, params);
    int32_t lines = 0;
    if (!result) result = exr_get_scanlines_per_chunk(file, 0, &lines);
    Rectangle held = image_window(image);
    for (int y = held.y; !result && y < held.y + held.height; y += lines)
        result = chunk_write(file, image, y);
    /* Writes the table of chunks, so it can fail as well. */
    exr_result_t finished = file ? exr_finish(&file) : result;
    if (!result) result = finished;
    return result ? error_set(error, STATUS_OUTPUT, "EXR: %s", exr_reason(result)) : true;
}
