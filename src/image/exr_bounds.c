#include "image/exr_bounds.h"

#include "base/budget.h"
#include "image/codec.h"
#include "image/exr_stream.h"
#include "image/image_bounds.h"

#include <stdint.h>
#include <string.h>

/* What is unpacked of any file, and how much more of a larger one for each of its bytes. */
static const size_t unpacked_floor = (size_t)512 << 20, unpacked_factor = 64;

typedef struct Count {
    const char *at, *end;
    int channels, attributes, parts;
} Count;

/* Skips a name with its zero byte; false where there is none. */
static bool skip_name(const char **at, const char *end) {
    const char *zero = *at < end ? memchr(*at, 0, (size_t)(end - *at)) : NULL;
    if (zero) *at = zero + 1;
    return zero != NULL;
}

/* A list of channels: names with 16 bytes behind each, up to an empty name. */
static int count_channels(const char *at, const char *end) {
    int count = 0;
    while (at < end && *at && skip_name(&at, end) && end - at >= 16) at += 16, count++;
    return count;
}

/* One attribute: its name, its type, its size and its value. False where it is broken. */
static bool count_attribute(Count *count) {
    static const char channels[] = "chlist";
    const char *at = count->at;
    if (!skip_name(&at, count->end)) return false;
    const char *type = at;
    if (!skip_name(&at, count->end) || count->end - at < 4) return false;
    uint32_t size = 0;
    for (int i = 0; i < 4; i++) size |= (uint32_t)(unsigned char)at[i] << (8 * i);
    at += 4;
    if (size > (size_t)(count->end - at)) return false;
    if (strcmp(type, channels) == 0) count->channels += count_channels(at, at + size);
    count->attributes++;
    count->at = at + size;
    return true;
}

static bool too_many(const char *path, int count, const char *what, int most, Error *error) {
    return error_set(error, STATUS_FAILURE, "%s: EXR of %d %s: at most %d can be read", path, count, what,
                     most);
}

bool exr_bounds_count(const Text *file, const char *path, Error *error) {
    enum { START = 8, PARTS_BIT = 0x10 };
    if (file->size < START) return true;
    Count count = {.at = file->data + START, .end = file->data + file->size};
    bool many = file->data[5] & PARTS_BIT;
    /* A header ends with an empty name, and so does the list of headers where there may be several. */
    while (count.at < count.end && *count.at) {
        while (count.at < count.end && *count.at && count_attribute(&count)) {
        }
        if (count.at >= count.end || *count.at) break;
        count.at++;
        count.parts++;
        if (!many) break;
    }
    if (count.channels > EXR_CHANNELS_MOST)
        return too_many(path, count.channels, "channels", EXR_CHANNELS_MOST, error);
    if (count.attributes > EXR_ATTRIBUTES_MOST)
        return too_many(path, count.attributes, "attributes", EXR_ATTRIBUTES_MOST, error);
    return count.parts <= EXR_PARTS_MOST || too_many(path, count.parts, "parts", EXR_PARTS_MOST, error);
}

static bool tables_fit(exr_context_t exr, const Text *file, const char *path, Error *error) {
    int parts = 0;
    uint64_t chunks = 0;
    exr_result_t result = exr_get_count(exr, &parts);
    for (int part = 0; !result && part < parts; part++) {
        int32_t count = 0;
        result = exr_get_chunk_count(exr, part, &count);
        chunks += count > 0 ? (uint64_t)count : 0;
    }
    if (result) return exr_broken(result, path, error);
    return chunks <= file->size / 8 ||
           error_set(error, STATUS_FAILURE,
                     "%s: broken EXR: the places of its %llu chunks take more than the %zu bytes that it has",
                     path, (unsigned long long)chunks, file->size);
}

/* The rows and columns of a chunk. */
static exr_result_t chunk_size(exr_context_t exr, int part, uint64_t width, uint64_t *chunk_width,
                               uint64_t *chunk_height) {
    exr_storage_t storage;
    int32_t tile_width = 0, lines = 0;
    exr_result_t result = exr_get_storage(exr, part, &storage);
    if (!result && storage == EXR_STORAGE_TILED)
        result = exr_get_tile_sizes(exr, part, 0, 0, &tile_width, &lines);
    else if (!result)
        result = exr_get_scanlines_per_chunk(exr, part, &lines);
    *chunk_width = tile_width > 0 && (uint64_t)tile_width < width ? (uint64_t)tile_width : width;
    *chunk_height = lines > 0 ? (uint64_t)lines : 1;
    return result;
}

static bool size_check(exr_attr_box2i_t window, const char *what, const char *path, Error *error) {
    int64_t width = (int64_t)window.max.x - window.min.x + 1;
    int64_t height = (int64_t)window.max.y - window.min.y + 1;
    if (width >= 1 && height >= 1 && width <= IMAGE_SIDE_MAX && height <= IMAGE_SIDE_MAX &&
        width * height <= IMAGE_PIXELS_MAX)
        return true;
    return error_set(error, STATUS_FAILURE,
                     "%s: EXR with a %s window of %lldx%lld: at most %dx%d and %ld pixels can be read", path,
                     what, (long long)width, (long long)height, IMAGE_SIDE_MAX, IMAGE_SIDE_MAX,
                     IMAGE_PIXELS_MAX);
}

static bool windows_check(const exr_attr_box2i_t *data, const exr_attr_box2i_t *display, const char *path,
                          Error *error) {
    if (!size_check(*data, "data", path, error) || !size_check(*display, "display", path, error))
        return false;
    if (data->min.x <= display->max.x && data->max.x >= display->min.x && data->min.y <= display->max.y &&
        data->max.y >= display->min.y)
        return true;
    return error_set(error, STATUS_FAILURE,
                     "%s: EXR whose data window (from %d,%d to %d,%d) is outside of its display window (from "
                     "%d,%d to %d,%d)",
                     path, data->min.x, data->min.y, data->max.x, data->max.y, display->min.x, display->min.y,
                     display->max.x, display->max.y);
}

/* Checks what has to be unpacked for the part, and gives the bytes that it takes besides the picture. */
static bool check_unpacked(exr_context_t exr, int part, const exr_attr_box2i_t *window, const Text *file,
                           const char *path, size_t *memory, Error *error) {
    const exr_attr_chlist_t *channels = NULL;
    uint64_t pixel = 0, chunk_width = 0, chunk_height = 0;
    uint64_t width = (uint64_t)((int64_t)window->max.x - window->min.x + 1),
             height = (uint64_t)((int64_t)window->max.y - window->min.y + 1);
    exr_result_t result = exr_get_channels(exr, part, &channels);
    if (!result) result = chunk_size(exr, part, width, &chunk_width, &chunk_height);
    if (result) return exr_broken(result, path, error);
    for (int i = 0; i < channels->num_channels; i++)
        pixel += channels->entries[i].pixel_type == EXR_PIXEL_HALF ? 2 : 4;
    /* The pixels and the channels are bounded, far from an overflow. */
    uint64_t unpacked = width * height * pixel, most = unpacked_floor + unpacked_factor * file->size,
             allowed = 2 * (uint64_t)budget_left(0);
    if (allowed > most) most = allowed;
    if (chunk_height > height) chunk_height = height;
    /* What is packed, what is unpacked, and OpenEXR's place for the way between. */
    *memory = (size_t)(3 * chunk_width * chunk_height * pixel);
    return unpacked <= most ||
           error_set(error, STATUS_FAILURE,
                     "%s: EXR that unpacks to %s: at most %s are unpacked of a file of %zu bytes "
                     "(--max-memory SIZE allows twice as much)",
                     path, bytes_up(unpacked).text, bytes_down(most).text, file->size);
}

static size_t pixels_of(const exr_attr_box2i_t *window) {
    return (size_t)(window->max.x - window->min.x + 1) * (size_t)(window->max.y - window->min.y + 1);
}

bool exr_bounds_take(exr_context_t exr, int part, const Text *file, const char *path, Error *error) {
    exr_attr_box2i_t data, display;
    size_t more = 0;
    exr_result_t result = exr_get_data_window(exr, part, &data);
    if (!result) result = exr_get_display_window(exr, part, &display);
    if (result) return exr_broken(result, path, error);
    if (!windows_check(&data, &display, path, error) || !tables_fit(exr, file, path, error) ||
        !check_unpacked(exr, part, &data, file, path, &more, error))
        return false;
    /* The picture is made anew where the windows are not the same. */
    if (memcmp(&data, &display, sizeof data) != 0) more += 4 * sizeof(float) * pixels_of(&display);
    return image_bounds_take(path, (size_t)(data.max.x - data.min.x + 1),
                             (size_t)(data.max.y - data.min.y + 1), more, file->size, error);
}
