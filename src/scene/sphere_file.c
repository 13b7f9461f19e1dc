#include "scene/sphere_file.h"

#include "base/lines.h"
#include "base/memory.h"
#include "base/number.h"

#include <stdlib.h>
#include <string.h>

static const char *const columns[4] = {"x", "y", "z", "radius"};

static bool read_row(char *line, float *sphere, Error *error) {
    for (int i = 0; i < 4; i++) {
        double value;
        if (!line) return error_set(error, STATUS_SCENE, "a row needs x,y,z,radius");
        char *word = line + strspn(line, " \t"), *end = word + strcspn(word, ",");
        line = *end ? end + 1 : NULL;
        while (end > word && strchr(" \t", end[-1])) end--;
        *end = 0;
        if (!number_parse_range(columns[i], word, -1e7, 1e7, &value, error)) return false;
        sphere[i] = (float)value;
        if (i == 3 && !(sphere[i] > 0))
            return error_set(error, STATUS_SCENE, "radius: '%s' is not above 0", word);
    }
    return true;
}

/* `rows`: lines so far that are neither empty nor comments. */
static bool read_line(char *line, int *rows, int most, float **spheres, int *count, Error *error) {
    const char *start = line + strspn(line, " \t");
    if (!*start || *start == '#') return true;
    if (!(*rows)++ && *start == 'x') return true;
    if (*count == most) return error_set(error, STATUS_SCENE, "more than %d spheres", most);
    /* Doubled each time it is full. */
    if (!(*count & (*count - 1)))
        *spheres = memory_grow(*spheres, 2 * (size_t)*count + 1, 4 * sizeof **spheres);
    return read_row(line, *spheres + 4 * (*count)++, error);
}

bool sphere_file_parse(const SourceFile *file, int most, float **spheres, int *count, Error *error) {
    int rows = 0;
    bool ok = true;
    *spheres = NULL;
    *count = 0;
    Lines lines = lines_of(text_string(&file->text));
    for (char *line; ok && (line = lines_next(&lines));) {
        ok = read_line(line, &rows, most, spheres, count, error);
        if (!ok) error->status = STATUS_SCENE, error_prefix(error, "%s:%d: ", file->path, lines.number);
    }
    lines_free(&lines);
    if (!ok) free(*spheres), *spheres = NULL, *count = 0;
    return ok;
}
