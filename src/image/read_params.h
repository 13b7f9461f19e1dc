/* What is read of a file, and how. */
#pragma once

#include "base/text.h"

/* Zero is the default. */
typedef struct ImageReadParams {
    /* The layer of an EXR, as exr_layers.h names it. If it is NULL, the picture itself. */
    const char *layer;
    /* If it is not NULL, what a reader of figures should know is appended: a line for each conversion, and
     * for each choice that could have been another. */
    Text *said;
    /* If it is not NULL, it gets the file's bytes, for image_attribute(). To be freed. */
    Text *bytes;
} ImageReadParams;
