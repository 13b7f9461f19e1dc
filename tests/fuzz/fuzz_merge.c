/* Parts of pictures: the sums and the metadata that `merge` reads. */
#include "fuzz/input.h"

#include "base/budget.h"
#include "error/merge.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = input_file("part.exr", data, size);
    Merge merge;
    Error error = {0};
    /* Little, so that what is within the bounds is quick. */
    budget_set(32 << 20);
    if (merge_files(&merge, &path, 1, true, &error)) merge_free(&merge);
    budget_give((size_t)-1);
    return 0;
}
