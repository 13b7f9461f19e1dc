/* The one reader of text files by lines. Files may begin with a byte order mark, end their lines in CR LF,
 * and lack the last line's end.
 *
 *     Text text = {0};
 *     bool ok = lines_read(path, STATUS_SCENE, &text, error);
 *     Lines lines = lines_of(text_string(&text));
 *     for (char *line; ok && (line = lines_next(&lines));)
 *         if (!read(line, error)) ok = error_prefix(error, "%s:%d: ", path, lines.number);
 *     lines_free(&lines);
 *     text_free(&text);
 */
#pragma once

#include "base/file.h"

typedef struct Lines {
    /* What is still to be read, in the caller's text. */
    const char *rest;
    /* The number of the line that was read last, from 1. */
    int number;
    /* Whether that line had an end; only the text's last may lack it. */
    bool ended;
    Text line;
} Lines;

/* The most bytes of a text file. */
#define LINES_MOST ((size_t)64 << 20)

/* Appends a text file's content without its byte order mark. A file that holds a zero byte is refused with
 * `status`: "PATH:1: not a text file". */
MUST_CHECK bool lines_read(const char *path, Status status, Text *text, Error *error);

/* The same for what is open already; `path` is its name for errors. */
MUST_CHECK bool lines_read_open(int descriptor, const char *path, const FileBounds *bounds, Text *text,
                                Error *error);

/* Reads the lines of `text`, which stays as it is and has to outlive the reader. */
Lines lines_of(const char *text);

/* The next line without its LF or CR LF, or NULL after the last. The line is a copy that the caller may cut;
 * it is valid until the next call. */
char *lines_next(Lines *lines);

void lines_free(Lines *lines);
