#include "cmd/info_file.h"

#include "base/file.h"
#include "error/checkpoint.h"
#include "image/format.h"

#include <stdio.h>
#include <string.h>

bool info_is_file(const char *path) {
    char start[32];
    if (file_is_special(path)) return false;
    FILE *file = fopen(path, "rb");
    if (!file) return false;
    size_t size = fread(start, 1, sizeof start, file);
    fclose(file);
    Text text = {.data = start, .size = size};
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
