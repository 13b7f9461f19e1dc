/* PNG files, with their metadata. */
#include "fuzz/input.h"

#include "image/codec.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    input_picture(data, size, png_decode);
    return 0;
}
