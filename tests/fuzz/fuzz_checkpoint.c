/* Checkpoints, as `info` reads them. */
#include "fuzz/input.h"

#include "error/checkpoint.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Text file = input_text(data, size), lines = {0};
    Error error;
    if (checkpoint_is_one(&file)) (void)!checkpoint_lines("fuzz", &file, &lines, &error);
    text_free(&lines);
    text_free(&file);
    return 0;
}
