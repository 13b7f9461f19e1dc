/* A picture in memory: rows of linear RGBA float pixels, row 0 at the top, and layers beside them. */
#pragma once

#include "base/error.h"
#include "base/text.h"

/* What else is known of each pixel. Only EXR keeps it, in channels named by the layer and a letter:
 * "normal.X", or "Z" alone where the layer has no name. */
typedef struct ImageLayer {
    const char *name;     /* "normal"; may be "" */
    const char *channels; /* a letter each: "XYZ" */
    float *data;          /* strlen(channels) floats a pixel, in rows; owned by the image */
} ImageLayer;

typedef struct Image {
    int width, height;
    float *rgba;        /* 4 * width * height, owned; alpha is 1 where a sample was taken, else 0 */
    ImageLayer *layers; /* owned; none in a picture that was read */
    int layer_count;
} Image;

/* A zeroed picture. */
Image image_create(int width, int height);
void image_free(Image *image);

/* Adds a layer and gives its zeroed data, to be filled. The strings stay the caller's. */
float *image_add_layer(Image *image, const char *name, const char *channels);

/* One line of metadata. The name is an EXR attribute's, such as "magichour.seed". */
typedef struct Attribute {
    char *name; /* both owned by the list */
    char *value;
} Attribute;

/* A zeroed list is empty. */
typedef struct AttributeList {
    Attribute *items; /* owned */
    int count;
} AttributeList;

void attribute_add(AttributeList *list, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void attribute_list_free(AttributeList *list);

typedef enum Tone {
    TONE_AUTHOR, /* the author's tone curve, Narkowicz's fit of ACES */
    TONE_NONE    /* clamp at 1 */
} Tone;

/* How linear radiance becomes what a file holds. Zero is the default. */
typedef struct ImageWriteParams {
    double exposure_ev;              /* display formats only: radiance is multiplied by 2^exposure */
    Tone tone;                       /* display formats only */
    bool latlong;                    /* EXR: a map of all directions, in OpenEXR's lat-long layout */
    const AttributeList *attributes; /* may be NULL */
} ImageWriteParams;

/* Whether the path's extension (.exr, .png, .pfm) names a format that can be written; STATUS_USAGE if not.
 * A device or pipe without an extension is given EXR. */
MUST_CHECK bool image_check_path(const char *path, Error *error);

/* Whether a picture written to this path keeps its layers. */
bool image_keeps_layers(const char *path);

/* Encodes by the path's extension and replaces the file (see file_replace). */
MUST_CHECK bool image_write(const Image *image, const char *path, const ImageWriteParams *params,
                            Error *error);

/* Reads .exr or .pfm (told apart by content). Missing alpha becomes 1; a luminance-only file becomes grey.
 * Fails with STATUS_FAILURE and leaves an empty picture. */
MUST_CHECK bool image_read(Image *image, const char *path, Error *error);

/* Appends the metadata of that name, as an EXR file has it; false where there is no such file or line. */
MUST_CHECK bool exr_attribute(const char *path, const char *name, Text *value);

/* Decoders refuse more than this many columns, rows, or pixels in all: broken headers ask for anything. */
#define IMAGE_SIDE_MAX 65536
#define IMAGE_PIXELS_MAX (1L << 28)

/* The formats, one file each. Encoders append the file's bytes to `out`; their errors do not know the path.
 * Decoders take the whole file, with its path for the errors. */
MUST_CHECK bool exr_encode(const Image *image, const ImageWriteParams *params, Text *out, Error *error);
MUST_CHECK bool exr_decode(Image *image, const char *path, const Text *file, Error *error);
MUST_CHECK bool png_encode(const Image *image, const ImageWriteParams *params, Text *out, Error *error);
void pfm_encode(const Image *image, Text *out);
MUST_CHECK bool pfm_decode(Image *image, const char *path, const Text *file, Error *error);
