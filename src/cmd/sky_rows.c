#include "cmd/sky_rows.h"

#include "base/lines.h"
#include "base/memory.h"
#include "base/number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_LINES = 1000000 };

static const char header[] = "height_m,sun_el_deg,view_el_deg,az_deg";

static const struct {
    const char *name;
    double min, max;
} columns[4] = {
    {"height_m", 0, 1e6}, {"sun_el_deg", -90, 90}, {"view_el_deg", -90, 90}, {"az_deg", -360, 360}};

/* Cuts off the next word between commas, without the blanks around it. Returns false at the line's end. */
static bool next_word(char **line, char **word) {
    if (!*line) return false;
    *word = *line + strspn(*line, " \t");
    char *end = *word + strcspn(*word, ",");
    *line = *end ? end + 1 : NULL;
    while (end > *word && strchr(" \t", end[-1])) end--;
    *end = 0;
    return true;
}

static bool read_row(SkyRow *row, char *line, Error *error) {
    double values[4];
    char *word;
    for (int i = 0; i < 4; i++) {
        if (!next_word(&line, &word)) {
            return error_set(error, STATUS_USAGE, "a row needs %s", header);
        }
        if (!number_parse_range(columns[i].name, word, columns[i].min, columns[i].max, &values[i], error))
            return false;
        snprintf(row->words[i], sizeof row->words[i], "%s", word);
    }
    row->height_m = values[0];
    row->sun_el_deg = values[1];
    row->view_el_deg = values[2];
    row->az_deg = values[3];
    return true;
}

static bool read_line(SkyRows *rows, char *line, bool first, Error *error) {
    const char *start = line + strspn(line, " \t");
    if (!*start) return true;
    if (*start == '#') {
        text_print(&rows->comments, "%s\n", line);
        return true;
    }
    if (first && strncmp(start, "height_m", 8) == 0) return true;
    rows->rows = memory_grow(rows->rows, rows->count + 1, sizeof *rows->rows);
    rows->rows[rows->count] = (SkyRow){0};
    return read_row(&rows->rows[rows->count++], line, error);
}

/* A row takes more memory than its text, so that their number is checked before one is read. */
static bool check_count(const Text *file, const char *path, Error *error) {
    size_t lines = 0;
    for (size_t i = 0; i < file->size; i++) lines += file->data[i] == '\n';
    return lines <= MOST_LINES ||
           error_set(error, STATUS_USAGE, "%s: it has %zu lines, and at most %d can be read", path, lines,
                     MOST_LINES);
}

bool sky_rows_read(SkyRows *rows, const char *path, Error *error) {
    Text file = {0};
    *rows = (SkyRows){0};
    bool ok = lines_read(path, STATUS_USAGE, &file, error) && check_count(&file, path, error), first = true;
    Lines lines = lines_of(text_string(&file));
    for (char *line; ok && (line = lines_next(&lines));) {
        bool counts = !strchr("#", line[strspn(line, " \t")]);
        if (!read_line(rows, line, first, error)) ok = error_prefix(error, "%s:%d: ", path, lines.number);
        if (counts) first = false;
    }
    lines_free(&lines);
    text_free(&file);
    if (!ok) sky_rows_free(rows);
    return ok;
}

void sky_rows_free(SkyRows *rows) {
    for (size_t i = 0; i < rows->count; i++) free(rows->rows[i].values);
    free(rows->rows);
    text_free(&rows->comments);
    text_free(&rows->names);
    *rows = (SkyRows){0};
}

void sky_rows_add(SkyRows *rows, const char *name) {
    int column = rows->columns++;
    text_print(&rows->names, ",%s", name);
    for (size_t i = 0; column % 3 == 0 && i < rows->count; i++) {
        double *values = memory_grow(rows->rows[i].values, (size_t)column + 3, sizeof *values);
        for (int k = column; k < column + 3; k++) values[k] = 0;
        rows->rows[i].values = values;
    }
}

size_t sky_rows_done(const SkyRows *rows) {
    size_t done = 0;
    for (size_t i = 0; i < rows->count; i++) done += rows->rows[i].done >= rows->columns;
    return done;
}

void sky_rows_print(const SkyRows *rows, Text *out) {
    text_print(out, "%s%s%s\n", text_string(&rows->comments), header, text_string(&rows->names));
    for (size_t i = 0; i < rows->count; i++) {
        const SkyRow *row = &rows->rows[i];
        if (row->done < rows->columns) continue;
        for (int k = 0; k < 4; k++) text_print(out, "%s%s", k ? "," : "", row->words[k]);
        for (int k = 0; k < rows->columns; k++) text_print(out, ",%.9g", row->values[k]);
        text_print(out, "\n");
    }
}
