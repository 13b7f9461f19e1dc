/* EXR files that OpenEXR's C library cannot decompress. */
#pragma once

#include "base/text.h"
#include "image/image.h"

typedef struct ExrLossy {
    const Text *file;
    int part;
    /* The file's channels for red, green, blue and alpha. Alpha may be NULL, and red, green and blue may be
     * the same. */
    const char *channels[4];
    /* Where the data window begins. */
    int x, y;
} ExrLossy;

/* Fills the picture, which has the data window's size. Fails with a reason, which is cut to `size` bytes. */
MUST_CHECK bool exr_lossy_decode(const ExrLossy *lossy, Image *image, char *reason, size_t size);
