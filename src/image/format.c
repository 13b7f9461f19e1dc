#include "image/format.h"

#include "base/budget.h"
#include "base/file.h"
#include "image/codec.h"
#include "image/exr_attribute.h"
#include "image/png_attribute.h"

#include <string.h>
#include <strings.h>

typedef enum Format { FORMAT_EXR, FORMAT_PNG, FORMAT_PFM, FORMAT_COUNT } Format;

static const char *const format_extensions[FORMAT_COUNT] = {".exr", ".png", ".pfm"};

/* Finds the format of an ending such as ".png". */
static bool format_find(const char *extension, Format *format) {
    for (int i = 0; i < FORMAT_COUNT; i++) {
        if (strcasecmp(extension, format_extensions[i]) != 0) continue;
        *format = (Format)i;
        return true;
    }
    return false;
}

/* From the last dot of the path's last part on; "" if there is none, or nothing in front of it. */
static const char *extension_of(const char *path) {
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    return dot && dot != name ? dot : "";
}

bool image_knows_ending(const char *path) {
    Format format;
    return format_find(extension_of(path), &format);
}

/* The format that was asked for by its name, or else that of the path's ending. */
static bool format_choose(const char *path, const char *name, Format *format, Error *error) {
    const char *extension = extension_of(path);
    if (name) {
        for (int i = 0; i < FORMAT_COUNT; i++) {
            *format = (Format)i;
            if (strcmp(name, format_extensions[i] + 1) == 0) return true;
        }
        return error_set(error, STATUS_USAGE, "unknown format '%s' (known: exr, png, pfm)", name);
    }
    if (format_find(extension, format)) return true;
    if (!*extension && strcmp(path, "-") != 0 && file_is_special(path)) {
        *format = FORMAT_EXR;
        return true;
    }
    if (!*extension) {
        return error_set(error, STATUS_USAGE,
                         "%s: no ending names the format (.exr, .png or .pfm): name it by --format", path);
    }
    return error_set(error, STATUS_USAGE,
                     "%s: unknown ending '%s': .exr, .png and .pfm can be written (or name one by --format)",
                     path, extension);
}

bool image_check_target(const char *path, const char *format, Error *error) {
    Format chosen;
    if (!format_choose(path, format, &chosen, error)) return false;
    if (file_is_terminal(path))
        return error_set(
            error, STATUS_USAGE,
            "%s: this is a terminal: send the picture to a file or to a program (> FILE, | PROGRAM)", path);
    return file_check_target(path, error);
}

bool image_keeps_layers(const char *path, const char *format) {
    Format chosen;
    Error error;
    return format_choose(path, format, &chosen, &error) && chosen == FORMAT_EXR;
}

bool image_write(const Image *image, const char *path, const ImageWriteParams *params, Error *error) {
    Format format;
    if (!format_choose(path, params->format, &format, error)) return false;

    Text file = {0};
    bool encoded = true;
    if (format == FORMAT_EXR) encoded = exr_encode(image, params, &file, error);
    /* Only EXR knows of pictures that are a part of another. */
    bool crops = format != FORMAT_EXR && image->data.width > 0;
    Image cropped = crops ? image_crop(image, image->data) : (Image){0};
    const Image *whole = crops ? &cropped : image;
    if (format == FORMAT_PNG) encoded = png_encode(whole, params, &file, error);
    if (format == FORMAT_PFM) pfm_encode(whole, &file);
    image_free(&cropped);
    bool written =
        encoded ? file_replace(path, file.data, file.size, error) : error_prefix(error, "%s: ", path);
    text_free(&file);
    return written;
}

bool image_read(Image *image, const char *path, Error *error) {
    return image_read_as(image, path, NULL, error);
}

static bool begins_with(const Text *file, const char *bytes) {
    size_t size = strlen(bytes);
    return file->size >= size && memcmp(file->data, bytes, size) == 0;
}

static bool is_exr(const Text *file) {
    return begins_with(file, "\x76\x2f\x31\x01");
}

static bool is_pfm(const Text *file) {
    return begins_with(file, "PF") || begins_with(file, "Pf");
}

static bool is_png(const Text *file) {
    return begins_with(file, "\x89PNG");
}

static bool is_picture(const Text *file) {
    return is_exr(file) || is_pfm(file) || is_png(file);
}

static bool decode(Image *image, const char *path, const Text *file, const ImageReadParams *params,
                   Error *error) {
    if (is_exr(file)) return exr_decode(image, path, file, params, error);
    if (params && params->layer)
        return error_set(error, STATUS_FAILURE, "%s: no layer '%s': only EXR has layers", path,
                         params->layer);
    if (is_pfm(file)) return pfm_decode(image, path, file, error);
    if (is_png(file)) return png_decode(image, path, file, params, error);
    return error_set(error, STATUS_FAILURE, "%s: neither an EXR nor a PFM nor a PNG picture", path);
}

bool image_read_as(Image *image, const char *path, const ImageReadParams *params, Error *error) {
    *image = (Image){0};
    Text file = {0};
    /* What is no picture is not read to its end, which a stream may not have. */
    FileBounds bounds = {.status = STATUS_FAILURE, .most = budget_left(FILE_MOST), .begins_well = is_picture};
    bool input = strcmp(path, "-") == 0;
    bool read =
        input ? file_read_input(&bounds, &file, error) : file_read_within(path, &bounds, &file, error);
    read = read && decode(image, input ? "standard input" : path, &file, params, error);
    if (read && params && params->bytes)
        *params->bytes = file;
    else
        text_free(&file);
    return read;
}

bool image_attribute(const Text *file, const char *name, Text *value) {
    return exr_attribute(file, name, value) || png_attribute(file, name, value);
}

bool image_is_one(const Text *start) {
    return is_picture(start);
}

bool image_describe(const char *path, const Text *file, Text *lines, Error *error) {
    Image image;
    if (exr_describe(file, lines) || png_describe(file, lines)) return true;
    if (!is_pfm(file)) return error_set(error, STATUS_FAILURE, "%s: broken picture", path);
    if (!pfm_decode(&image, path, file, error)) return false;
    text_print(lines, "PFM of %dx%d\n", image.width, image.height);
    image_free(&image);
    return true;
}
