#include "base/lines.h"

#include <string.h>

static const char byte_order_mark[] = "\xef\xbb\xbf";

/* Makes a text of what was read behind `start`. */
static bool content_check(const char *path, Status status, Text *text, size_t start, Error *error) {
    size_t mark = strlen(byte_order_mark);
    if (text->size > start && memchr(text->data + start, 0, text->size - start))
        return error_set(error, status, "%s:1: not a text file", path);
    if (text->size >= start + mark && memcmp(text->data + start, byte_order_mark, mark) == 0) {
        memmove(text->data + start, text->data + start + mark, text->size - start - mark + 1);
        text->size -= mark;
    }
    return true;
}

bool lines_read_open(int descriptor, const char *path, const FileBounds *bounds, Text *text, Error *error) {
    size_t start = text->size;
    return file_read_open(descriptor, path, bounds, text, error) &&
           content_check(path, bounds->status, text, start, error);
}

bool lines_read(const char *path, Status status, Text *text, Error *error) {
    size_t start = text->size;
    return file_read_within(path, &(FileBounds){.status = status, .most = LINES_MOST}, text, error) &&
           content_check(path, status, text, start, error);
}

Lines lines_of(const char *text) {
    return (Lines){.rest = text};
}

char *lines_next(Lines *lines) {
    if (!*lines->rest) return NULL;
    size_t length = strcspn(lines->rest, "\n");
    lines->ended = lines->rest[length] == '\n';
    lines->line.size = 0;
    text_append(&lines->line, lines->rest, length);
    if (length && lines->line.data[length - 1] == '\r') lines->line.data[length - 1] = 0;
    lines->rest += length + lines->ended;
    lines->number++;
    return lines->line.data;
}

void lines_free(Lines *lines) {
    text_free(&lines->line);
}
