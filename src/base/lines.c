#include "base/lines.h"

#include "base/file.h"

#include <string.h>

static const char byte_order_mark[] = "\xef\xbb\xbf";

bool lines_read(const char *path, Status status, Text *text, Error *error) {
    Text content = {0};
    bool ok = file_read(path, status, &content, error);
    if (ok && content.size && memchr(content.data, 0, content.size))
        ok = error_set(error, status, "%s:1: not a text file", path);
    if (ok) {
        size_t mark = strlen(byte_order_mark);
        bool marked = strncmp(text_string(&content), byte_order_mark, mark) == 0;
        text_append(text, text_string(&content) + (marked ? mark : 0), content.size - (marked ? mark : 0));
    }
    text_free(&content);
    return ok;
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
