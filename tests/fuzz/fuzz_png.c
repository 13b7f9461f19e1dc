/* PNG files, with their metadata. */
#include "fuzz/input.h"

#include "base/budget.h"
#include "image/codec.h"
#include "image/format.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Text file = input_text(data, size), said = {0}, value = {0};
    Image image;
    Error error;
    /* Little, so that what is within the bounds is quick. */
    budget_set(32 << 20);
    if (png_decode(&image, "fuzz.png", &file, &(ImageReadParams){.said = &said}, &error)) image_free(&image);
    (void)!image_attribute(&file, "magichour.command", &value);
    budget_give((size_t)-1);
    text_free(&value);
    text_free(&said);
    text_free(&file);
    return 0;
}
