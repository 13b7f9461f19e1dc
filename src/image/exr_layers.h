/* The layers of an EXR file, and which of them is the picture. */
#pragma once

#include "base/text.h"

#include <openexr.h>

typedef enum ExrKind {
    /* The channels R, G, B, and A where there is one. */
    EXR_KIND_RGB,
    /* The channels X, Y, Z: colours of CIE 1931 where they have no layer's name, any vector else. */
    EXR_KIND_XYZ,
    /* One channel. */
    EXR_KIND_GREY
} ExrKind;

typedef struct ExrLayer {
    /* What chooses it: the channels' name up to the last dot, or else the part's name, which is "" in a file
     * of one part. A channel that belongs to no other has its whole name. If two layers would have the same
     * name, the part's name and a dot come first. */
    char name[512];
    ExrKind kind;
    int part;
    /* Whether the channels' names have no layer in front. */
    bool plain;
    /* Which of the part's channels are red, green, blue and alpha; -1 if there is none. */
    int channels[4];
} ExrLayer;

/* Finds the layer of that name. If the name is NULL, it is the first of these that there is exactly one of:
 *
 *  1. R, G, B without a layer's name; if several parts have them, that of the part "rgba", "beauty" or
 *     "combined" (as the last word of the name, in any case);
 *  2. R, G, B of a layer with such a name;
 *  3. R, G, B of any layer;
 *  4. X, Y, Z, or Y alone, without a layer's name.
 *
 * Fails with STATUS_FAILURE and a list of the layers. Appends to `said`, which may be NULL, what a reader
 * should know of the choice. */
MUST_CHECK bool exr_layer_find(exr_context_t file, const char *name, const char *path, ExrLayer *layer,
                               Text *said, Error *error);
