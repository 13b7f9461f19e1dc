#include "cmd/info_file.h"

#include "base/file.h"
#include "base/regular.h"
#include "error/checkpoint.h"
#include "image/format.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

bool info_is_file(const char *path) {
    char start[32];
    struct stat found;
    Error ignored;
    int descriptor = regular_open(path, &found, STATUS_FAILURE, &ignored);
    if (descriptor < 0) return false;
    ssize_t size = read(descriptor, start, sizeof start);
    close(descriptor);
    Text text = {.data = start, .size = size > 0 ? (size_t)size : 0};
    return image_is_one(&text) || checkpoint_is_one(&text);
}

bool info_print_file(const char *path, Error *error) {
    Text file = {0}, lines = {0};
    FileBounds bounds = {.status = STATUS_FAILURE, .most = CHECKPOINT_MOST};
    bool ok = file_read_within(path, &bounds, &file, error);
    if (ok && checkpoint_is_one(&file)) {
        text_print(&lines, "a checkpoint, for `render --resume`\n");
        ok = checkpoint_lines(path, &file, &lines, error);
    } else if (ok) {
        ok = image_describe(path, &file, &lines, error);
    }
    if (ok) printf("%s: %s", path, text_string(&lines));
    text_free(&file);
    text_free(&lines);
    return ok;
}
