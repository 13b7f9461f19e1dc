#include "chart/points.h"

#include "base/lines.h"
#include "base/number.h"

#include <stdio.h>
#include <string.h>

static const char columns[] = "program,seconds,percent";

/* Finds the program of this name, or adds it. */
static ProgramPoints *program_of(Points *points, const char *name, Error *error) {
    for (int i = 0; i < points->count; i++) {
        if (strcmp(points->programs[i].name, name) == 0) return &points->programs[i];
    }
    if (points->count == MOST_PROGRAMS) {
        error_set(error, STATUS_USAGE, "more than %d programs", MOST_PROGRAMS);
        return NULL;
    }
    ProgramPoints *program = &points->programs[points->count++];
    snprintf(program->name, sizeof program->name, "%s", name);
    return program;
}

static bool read_positive(const char *what, const char *text, double *value, Error *error) {
    if (number_parse(text, value) && *value > 0) return true;
    return error_set(error, STATUS_USAGE, "%s '%.40s' is not a number above 0", what, text);
}

static bool read_row(Points *points, char *line, Error *error) {
    char *seconds = strchr(line, ','), *percent = seconds ? strchr(seconds + 1, ',') : NULL;
    if (!percent || seconds == line) return error_set(error, STATUS_USAGE, "a row is %s", columns);
    *seconds++ = 0;
    *percent++ = 0;
    ParetoPoint point;
    if (strlen(line) >= sizeof points->programs[0].name)
        return error_set(error, STATUS_USAGE, "the name of a program has at most %d bytes",
                         (int)sizeof points->programs[0].name - 1);
    if (!read_positive("seconds", seconds, &point.seconds, error) ||
        !read_positive("percent", percent, &point.percent, error))
        return false;
    ProgramPoints *program = program_of(points, line, error);
    if (!program) return false;
    if (program->count == MOST_PROGRAM_POINTS)
        return error_set(error, STATUS_USAGE, "more than %d points of a program", MOST_PROGRAM_POINTS);
    if (program->count && point.seconds <= program->points[program->count - 1].seconds)
        return error_set(error, STATUS_USAGE, "the points of a program are in the order of time");
    program->points[program->count++] = point;
    return true;
}

static bool read_line(Points *points, char *line, bool *headed, Error *error) {
    if (!*line || *line == '#') return true;
    if (*headed) return read_row(points, line, error);
    *headed = true;
    return strcmp(line, columns) == 0 ||
           error_set(error, STATUS_USAGE, "the first line is '%.60s', and not '%s'", line, columns);
}

bool points_read(Points *points, const char *path, Error *error) {
    Text text = {0};
    *points = (Points){0};
    bool ok = lines_read(path, STATUS_USAGE, &text, error), headed = false;
    Lines lines = lines_of(ok ? text_string(&text) : "");
    for (char *line; ok && (line = lines_next(&lines));) {
        if (!read_line(points, line, &headed, error)) ok = error_prefix(error, "%s:%d: ", path, lines.number);
    }
    if (ok && !points->count) ok = error_set(error, STATUS_USAGE, "%s: no points", path);
    lines_free(&lines);
    text_free(&text);
    return ok;
}
