#include "image/codec.h"
#include "image/exr_bounds.h"
#include "image/exr_layers.h"
#include "image/exr_lossy.h"
#include "image/exr_stream.h"

#include <math.h>
#include <string.h>

typedef struct Reader {
    exr_context_t file;
    /* The pixels of the data window. */
    Image *image;
    exr_attr_box2i_t data, display;
    exr_storage_t storage;
    exr_compression_t compression;
    ExrLayer layer;
} Reader;

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
                if (reader->layer.channels[c] != i) continue;
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
    exr_result_t result = exr_decoding_initialize(reader->file, reader->layer.part, chunk, &pipeline);
    if (!result && !chunk_fits(reader, &pipeline, x, y)) result = EXR_ERR_CORRUPT_CHUNK;
    if (!result) result = exr_decoding_choose_default_routines(reader->file, reader->layer.part, &pipeline);
    pipeline.unpack_and_convert_fn = NULL;
    if (!result) result = exr_decoding_run(reader->file, reader->layer.part, &pipeline);
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
    exr_result_t result = exr_get_scanlines_per_chunk(reader->file, reader->layer.part, &lines);
    for (int y = 0; !result && y < reader->image->height; y += lines) {
        exr_chunk_info_t chunk;
        result =
            exr_read_scanline_chunk_info(reader->file, reader->layer.part, reader->data.min.y + y, &chunk);
        if (!result) result = chunk_decode(reader, &chunk, 0, y);
    }
    return result;
}

/* The first level, which is the whole picture. */
static exr_result_t tiles_decode(const Reader *reader) {
    int32_t width = 0, height = 0;
    exr_result_t result = exr_get_tile_sizes(reader->file, reader->layer.part, 0, 0, &width, &height);
    for (int y = 0; !result && y < reader->image->height; y += height) {
        for (int x = 0; !result && x < reader->image->width; x += width) {
            exr_chunk_info_t chunk;
            result = exr_read_tile_chunk_info(reader->file, reader->layer.part, x / width, y / height, 0, 0,
                                              &chunk);
            if (!result) result = chunk_decode(reader, &chunk, x, y);
        }
    }
    return result;
}

/* As of 3.1.5, OpenEXR's C library lacks DWA, and its B44 gives wrong pictures. */
static bool is_lossy(exr_compression_t compression) {
    return compression > EXR_COMPRESSION_PXR24;
}

static bool lossy_decode(const Reader *reader, const Text *file, const char *path, Error *error) {
    const exr_attr_chlist_t *list = NULL;
    const char *names[4] = {NULL};
    char reason[256];
    exr_result_t result = exr_get_channels(reader->file, reader->layer.part, &list);
    if (result) return exr_broken(result, path, error);
    for (int c = 0; c < 4; c++) {
        if (reader->layer.channels[c] >= 0) names[c] = list->entries[reader->layer.channels[c]].name.str;
    }
    ExrLossy lossy = {
        .file = file, .part = reader->layer.part, .x = reader->data.min.x, .y = reader->data.min.y};
    memcpy(lossy.channels, names, sizeof names);
    if (exr_lossy_decode(&lossy, reader->image, reason, sizeof reason)) return true;
    if (!*reason) return exr_broken(EXR_ERR_OUT_OF_MEMORY, path, error);
    exr_line_clean(reason);
    return error_set(error, STATUS_FAILURE, "%s: broken EXR: %s", path, reason);
}

static bool pixels_decode(const Reader *reader, const Text *file, const char *path, Error *error) {
    if (is_lossy(reader->compression)) return lossy_decode(reader, file, path, error);
    exr_result_t result =
        reader->storage == EXR_STORAGE_TILED ? tiles_decode(reader) : scanlines_decode(reader);
    return !result || exr_broken(result, path, error);
}

/* Everything up to the pixels: fills the reader, and the size of the data window. */
static bool header_read(Reader *reader, const char *path, const Text *file, Error *error) {
    int part = reader->layer.part;
    const exr_attr_chlist_t *list = NULL;
    exr_result_t result = exr_get_storage(reader->file, part, &reader->storage);
    if (!result) result = exr_get_compression(reader->file, part, &reader->compression);
    if (!result) result = exr_get_data_window(reader->file, part, &reader->data);
    if (!result) result = exr_get_display_window(reader->file, part, &reader->display);
    if (!result) result = exr_get_channels(reader->file, part, &list);
    if (result) return exr_broken(result, path, error);

    if (reader->storage != EXR_STORAGE_SCANLINE && reader->storage != EXR_STORAGE_TILED)
        return error_set(error, STATUS_FAILURE, "%s: deep EXR pictures cannot be read", path);
    for (int i = 0; i < list->num_channels; i++) {
        if (list->entries[i].x_sampling != 1 || list->entries[i].y_sampling != 1)
            return error_set(error, STATUS_FAILURE, "%s: EXR with subsampled channels cannot be read", path);
    }
    if (!exr_bounds_take(reader->file, part, file, path, error)) return false;
    *reader->image = image_create(reader->data.max.x - reader->data.min.x + 1,
                                  reader->data.max.y - reader->data.min.y + 1);
    return true;
}

static void alpha_fill(Image *image) {
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) image->rgba[4 * i + 3] = 1;
}

/* CIE 1931, to the primaries of sRGB with its white, D65 (IEC 61966-2-1). */
static void rgb_from_xyz(Image *image) {
    static const double matrix[3][3] = {{3.2404541621, -1.5371385128, -0.4985314096},
                                        {-0.9692660305, 1.8760108454, 0.0415560175},
                                        {0.0556434310, -0.2040259135, 1.0572251882}};
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (float *pixel = image->rgba; pixel < image->rgba + 4 * pixels; pixel += 4) {
        double x = (double)pixel[0], y = (double)pixel[1], z = (double)pixel[2];
        for (int c = 0; c < 3; c++)
            pixel[c] = (float)(matrix[c][0] * x + matrix[c][1] * y + matrix[c][2] * z);
    }
}

/* Says so if the file's red, green and blue are others than sRGB's. */
static void primaries_say(const Reader *reader, Text *said) {
    static const float srgb[] = {0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F};
    exr_attr_chromaticities_t c;
    if (!said || exr_attr_get_chromaticities(reader->file, reader->layer.part, "chromaticities", &c)) return;
    const float its[] = {c.red_x, c.red_y, c.green_x, c.green_y, c.blue_x, c.blue_y, c.white_x, c.white_y};
    for (int i = 0; i < 8; i++) {
        if (fabsf(its[i] - srgb[i]) <= 0.001F) continue;
        text_print(said, "its primaries or its white are not sRGB's: values are taken as they are\n");
        return;
    }
}

/* Puts the pixels of the data window where they lie in the display window. */
static void window_place(const Reader *reader, Text *said) {
    const exr_attr_box2i_t *data = &reader->data, *display = &reader->display;
    if (memcmp(data, display, sizeof *data) == 0) return;
    Image *from = reader->image;
    Image placed = image_create(display->max.x - display->min.x + 1, display->max.y - display->min.y + 1);
    int dx = data->min.x - display->min.x, dy = data->min.y - display->min.y;
    int left = dx > 0 ? dx : 0, top = dy > 0 ? dy : 0;
    int right = from->width + dx < placed.width ? from->width + dx : placed.width;
    int bottom = from->height + dy < placed.height ? from->height + dy : placed.height;
    for (int y = top; y < bottom; y++) {
        memcpy(placed.rgba + 4 * ((size_t)y * (size_t)placed.width + (size_t)left),
               from->rgba + 4 * ((size_t)(y - dy) * (size_t)from->width + (size_t)(left - dx)),
               4 * sizeof(float) * (size_t)(right - left));
    }
    placed.data = (Rectangle){left, top, right - left, bottom - top};
    if (said)
        text_print(said, "display window of %dx%d, data window of %dx%d at %d,%d in it\n", placed.width,
                   placed.height, from->width, from->height, dx, dy);
    image_free(from);
    *from = placed;
}

static bool picture_read(Reader *reader, const char *path, const Text *file, const ImageReadParams *params,
                         Error *error) {
    if (!exr_layer_find(reader->file, params->layer, path, &reader->layer, params->said, error) ||
        !header_read(reader, path, file, error) || !pixels_decode(reader, file, path, error))
        return false;
    if (reader->layer.channels[3] < 0) alpha_fill(reader->image);
    if (reader->layer.plain && reader->layer.kind == EXR_KIND_XYZ) rgb_from_xyz(reader->image);
    if (reader->layer.kind == EXR_KIND_RGB) primaries_say(reader, params->said);
    window_place(reader, params->said);
    return true;
}

bool exr_decode(Image *image, const char *path, const Text *file, const ImageReadParams *params,
                Error *error) {
    *image = (Image){0};
    if (!exr_bounds_count(file, path, error)) return false;
    ExrStream stream = {.in = file};
    exr_context_initializer_t settings = exr_settings(&stream);
    /* Broken headers and truncated pictures are errors: OpenEXR would make up what is missing. */
    settings.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;

    Reader reader = {.image = image};
    exr_result_t result = exr_start_read(&reader.file, path, &settings);
    if (result) return exr_broken(result, path, error);
    bool read = picture_read(&reader, path, file, params ? params : &(ImageReadParams){0}, error);
    exr_finish(&reader.file);
    if (!read) image_free(image);
    return read;
}
