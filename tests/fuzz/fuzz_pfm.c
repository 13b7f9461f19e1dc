/* PFM files. */
#include "fuzz/input.h"

#include "image/codec.h"

/* A PFM says nothing beside its picture. */
static bool decode(Image *image, const char *path, const Text *file, const ImageReadParams *params,
                   Error *error) {
    (void)params;
    return pfm_decode(image, path, file, error);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    input_picture(data, size, decode);
    return 0;
}
