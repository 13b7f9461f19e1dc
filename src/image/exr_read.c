#include "image/codec.h"
#include "image/exr_stream.h"

#include <string.h>

typedef struct Reader {
    exr_context_t file;
    Image *image;
    exr_attr_box2i_t window;
    int channels[4]; /* which of the file's channels are R, G, B, A; -1 if there is none */
} Reader;

static int channel_find(const exr_attr_chlist_t *list, const char *layer, int layer_length, char letter) {
    for (int i = 0; i < list->num_channels; i++) {
        const exr_attr_string_t *name = &list->entries[i].name;
        if (name->length == layer_length + 1 && name->str[layer_length] == letter &&
            memcmp(name->str, layer, (size_t)layer_length) == 0) {
            return i;
        }
    }
    return -1;
}

/* The channels "R" to "A" behind the layer's name and dot; whether there are at least the first three. */
static bool layer_find(const exr_attr_chlist_t *list, const char *layer, int layer_length, int channels[4]) {
    for (int c = 0; c < 4; c++) channels[c] = channel_find(list, layer, layer_length, "RGBA"[c]);
    return channels[0] >= 0 && channels[1] >= 0 && channels[2] >= 0;
}

static bool channels_choose(const exr_attr_chlist_t *list, Reader *reader) {
    if (layer_find(list, "", 0, reader->channels)) return true;
    int layers = 0, candidate[4];
    for (int i = 0; i < list->num_channels; i++) {
        const exr_attr_string_t *name = &list->entries[i].name;
        if (name->length < 2 || memcmp(name->str + name->length - 2, ".R", 2) != 0) continue;
        if (!layer_find(list, name->str, name->length - 1, candidate)) continue;
        memcpy(reader->channels, candidate, sizeof candidate);
        layers++;
    }
    if (layers) return layers == 1;
    int y = channel_find(list, "", 0, 'Y');
    reader->channels[0] = reader->channels[1] = reader->channels[2] = y;
    return y >= 0 && channel_find(list, "R", 1, 'Y') < 0; /* RY and BY would be its colour */
}

static bool channels_error(const exr_attr_chlist_t *list, const char *path, Error *error) {
    Text names = {0};
    for (int i = 0; i < list->num_channels; i++)
        text_print(&names, "%s %s", i ? "," : "", list->entries[i].name.str);
    if (names.data) exr_line_clean(names.data);
    error_set(error, STATUS_FAILURE,
              "%s: EXR with neither R, G, B nor one layer of them nor Y; its channels:%s", path,
              names.size ? text_string(&names) : " none");
    text_free(&names);
    return false;
}

static uint32_t bits_load(const uint8_t *bytes, int count) {
    uint32_t bits = 0;
    for (int i = 0; i < count; i++) bits |= (uint32_t)bytes[i] << (8 * i);
    return bits;
}

/* IEC 60559 binary16, into binary32. */
static uint32_t float_bits_from_half(uint32_t half) {
    uint32_t sign = (half & 0x8000) << 16, exponent = half >> 10 & 31, fraction = half & 0x3ff;
    if (exponent == 31) return sign | 0x7f800000 | fraction << 13;
    if (exponent) return sign | (exponent + 112) << 23 | fraction << 13;
    float subnormal = (float)fraction * 0x1p-24F;
    uint32_t bits;
    memcpy(&bits, &subnormal, sizeof bits);
    return sign | bits;
}

static float value_load(const uint8_t *bytes, exr_pixel_type_t type) {
    if (type == EXR_PIXEL_UINT) return (float)bits_load(bytes, 4);
    uint32_t bits = type == EXR_PIXEL_HALF ? float_bits_from_half(bits_load(bytes, 2)) : bits_load(bytes, 4);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* The bytes of a decompressed chunk lie line by line, in a line channel by channel. */
static void chunk_unpack(const Reader *reader, const exr_decode_pipeline_t *pipeline, const uint8_t *bytes,
                         float *place) {
    for (int line = 0; line < pipeline->chunk.height; line++, place += 4 * (size_t)reader->image->width) {
        for (int i = 0; i < pipeline->channel_count; i++) {
            const exr_coding_channel_info_t *channel = &pipeline->channels[i];
            for (int c = 0; c < 4; c++) {
                if (reader->channels[c] != i) continue;
                for (int x = 0; x < channel->width; x++) {
                    place[4 * x + c] = value_load(bytes + x * channel->bytes_per_element, channel->data_type);
                }
            }
            bytes += channel->width * channel->bytes_per_element;
        }
    }
}

/* Whether the chunk lies within the picture and is as long as its channels need. OpenEXR does not compare the
 * sizes of an uncompressed one: it would leave the missing pixels to chance. */
static bool chunk_fits(const Reader *reader, const exr_decode_pipeline_t *pipeline, int x, int y) {
    const exr_chunk_info_t *chunk = &pipeline->chunk;
    if (chunk->compression == EXR_COMPRESSION_NONE && chunk->packed_size != chunk->unpacked_size)
        return false;
    uint64_t size = 0;
    for (int i = 0; i < pipeline->channel_count; i++) {
        const exr_coding_channel_info_t *channel = &pipeline->channels[i];
        if (channel->width != chunk->width || channel->height != chunk->height) return false;
        size += (uint64_t)channel->width * (uint64_t)channel->height * (uint64_t)channel->bytes_per_element;
    }
    return chunk->width >= 0 && chunk->height >= 0 && chunk->width <= reader->image->width - x &&
           chunk->height <= reader->image->height - y && size == chunk->unpacked_size;
}

/* Decodes a chunk to the place that it has at column x and row y of the picture. OpenEXR only decompresses:
 * its own unpacking, as of 3.1.5, writes through the NULL that stands for an unwanted channel. */
static exr_result_t chunk_decode(const Reader *reader, const exr_chunk_info_t *chunk, int x, int y) {
    exr_decode_pipeline_t pipeline = EXR_DECODE_PIPELINE_INITIALIZER;
    exr_result_t result = exr_decoding_initialize(reader->file, 0, chunk, &pipeline);
    if (!result && !chunk_fits(reader, &pipeline, x, y)) result = EXR_ERR_CORRUPT_CHUNK;
    if (!result) result = exr_decoding_choose_default_routines(reader->file, 0, &pipeline);
    pipeline.unpack_and_convert_fn = NULL;
    if (!result) result = exr_decoding_run(reader->file, 0, &pipeline);
    if (!result && !pipeline.unpacked_buffer) result = EXR_ERR_CORRUPT_CHUNK;
    if (!result) {
        float *place = reader->image->rgba + 4 * ((size_t)y * (size_t)reader->image->width + (size_t)x);
        chunk_unpack(reader, &pipeline, pipeline.unpacked_buffer, place);
    }
    exr_decoding_destroy(reader->file, &pipeline);
    return result;
}

static exr_result_t scanlines_decode(const Reader *reader) {
    int32_t lines = 0;
    exr_result_t result = exr_get_scanlines_per_chunk(reader->file, 0, &lines);
    for (int y = 0; !result && y < reader->image->height; y += lines) {
        exr_chunk_info_t chunk;
        result = exr_read_scanline_chunk_info(reader->file, 0, reader->window.min.y + y, &chunk);
        if (!result) result = chunk_decode(reader, &chunk, 0, y);
    }
    return result;
}

/* The first level, which is the whole picture. */
static exr_result_t tiles_decode(const Reader *reader) {
    int32_t width = 0, height = 0;
    exr_result_t result = exr_get_tile_sizes(reader->file, 0, 0, 0, &width, &height);
    for (int y = 0; !result && y < reader->image->height; y += height) {
        for (int x = 0; !result && x < reader->image->width; x += width) {
            exr_chunk_info_t chunk;
            result = exr_read_tile_chunk_info(reader->file, 0, x / width, y / height, 0, 0, &chunk);
            if (!result) result = chunk_decode(reader, &chunk, x, y);
        }
    }
    return result;
}

static void alpha_fill(Image *image) {
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) image->rgba[4 * i + 3] = 1;
}

static bool broken_error(exr_result_t result, const char *path, Error *error) {
    return error_set(error, STATUS_FAILURE, "%s: broken EXR: %s", path, exr_reason(result));
}

/* As of 3.1.5, OpenEXR's C library lacks DWA, and its B44 gives wrong pictures. */
static bool compression_is_readable(exr_compression_t compression) {
    return compression <= EXR_COMPRESSION_PXR24;
}

/* Everything up to the pixels: fills the reader, and the picture's size. */
static bool header_read(Reader *reader, exr_storage_t *storage, const char *path, Error *error) {
    const exr_attr_chlist_t *list = NULL;
    exr_compression_t compression;
    exr_result_t result = exr_get_storage(reader->file, 0, storage);
    if (!result) result = exr_get_compression(reader->file, 0, &compression);
    if (!result) result = exr_get_data_window(reader->file, 0, &reader->window);
    if (!result) result = exr_get_channels(reader->file, 0, &list);
    if (result) return broken_error(result, path, error);

    if (*storage != EXR_STORAGE_SCANLINE && *storage != EXR_STORAGE_TILED) {
        return error_set(error, STATUS_FAILURE, "%s: deep EXR pictures cannot be read", path);
    }
    if (!compression_is_readable(compression)) {
        return error_set(
            error, STATUS_FAILURE,
            "%s: EXR pictures compressed by B44 or DWA cannot be read: use ZIP, PIZ, RLE or none", path);
    }
    int64_t width = (int64_t)reader->window.max.x - reader->window.min.x + 1;
    int64_t height = (int64_t)reader->window.max.y - reader->window.min.y + 1;
    if (width < 1 || height < 1 || width > IMAGE_SIDE_MAX || height > IMAGE_SIDE_MAX ||
        width * height > IMAGE_PIXELS_MAX) {
        return error_set(
            error, STATUS_FAILURE, "%s: EXR of %lldx%lld: at most %dx%d and %ld pixels can be read", path,
            (long long)width, (long long)height, IMAGE_SIDE_MAX, IMAGE_SIDE_MAX, IMAGE_PIXELS_MAX);
    }
    for (int i = 0; i < list->num_channels; i++) {
        if (list->entries[i].x_sampling != 1 || list->entries[i].y_sampling != 1) {
            return error_set(error, STATUS_FAILURE, "%s: EXR with subsampled channels cannot be read", path);
        }
    }
    if (!channels_choose(list, reader)) return channels_error(list, path, error);
    *reader->image = image_create((int)width, (int)height);
    return true;
}

bool exr_decode(Image *image, const char *path, const Text *file, Error *error) {
    *image = (Image){0};
    ExrStream stream = {.in = file};
    exr_context_initializer_t settings = exr_settings(&stream);
    /* Broken headers and truncated pictures are errors: OpenEXR would make up what is missing. */
    settings.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;

    Reader reader = {.image = image, .channels = {-1, -1, -1, -1}};
    exr_result_t result = exr_start_read(&reader.file, path, &settings);
    if (result) return broken_error(result, path, error);
    exr_storage_t storage;
    bool read = header_read(&reader, &storage, path, error);
    if (read) {
        result = storage == EXR_STORAGE_TILED ? tiles_decode(&reader) : scanlines_decode(&reader);
        read = result ? broken_error(result, path, error) : true;
    }
    if (read && reader.channels[3] < 0) alpha_fill(image);
    exr_finish(&reader.file);
    if (!read) image_free(image);
    return read;
}
