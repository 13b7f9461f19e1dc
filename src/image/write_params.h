/* How linear radiance becomes what a file holds. */
#pragma once

#include "image/attribute.h"
#include "image/tone.h"

#include <stdbool.h>

/* Zero is the default. */
typedef struct ImageWriteParams {
    /* "exr", "png" or "pfm". If it is NULL, the path's ending names the format. */
    const char *format;
    /* Of display formats only: radiance is multiplied by 2^exposure, then goes through the curve. */
    double exposure_ev;
    Tone tone;
    /* Of EXR: a map of all directions, in OpenEXR's lat-long layout. */
    bool latlong;
    /* May be NULL. */
    const AttributeList *attributes;
} ImageWriteParams;
