#include "image/image_bounds.h"

#include "base/budget.h"
#include "base/text.h"

bool image_bounds_take(const char *path, size_t width, size_t height, size_t more, size_t file_size,
                       Error *error) {
    Text what = {0};
    text_print(&what, "%s: the picture of %zux%zu pixels in a file of %zu bytes", path, width, height,
               file_size);
    size_t bytes = width * height * 4 * sizeof(float) + more;
    bool ok = budget_take(bytes, IMAGE_MEMORY_FLOOR + IMAGE_MEMORY_FACTOR * file_size, STATUS_FAILURE,
                          text_string(&what), error);
    text_free(&what);
    return ok;
}
