/* EXR files for tests, of any parts, layers and windows. */
#pragma once

#include "base/rectangle.h"

#include <stdbool.h>

/* Channel c of part p, in the order given here, has the value 100 p + c + 1 in all pixels. */
typedef struct ExrPart {
    const char *name;
    /* The channels' names, separated by blanks. */
    const char *channels;
} ExrPart;

typedef struct ExrFile {
    /* They end at the first part without channels. */
    ExrPart parts[4];
    /* If both are zeroed, 4x3 pixels. */
    Rectangle data, display;
    /* If it is not NULL, the values of the channels in their order, in place of those above. */
    const float *values;
    /* Whether all parts have the primaries of ACES2065-1. */
    bool aces;
} ExrFile;

/* Writes the file, or ends the test. */
void exr_file_write(const char *path, const ExrFile *file);
