/* The tables: directions of `sky --at`, points of `chart --points`, and spheres. The first byte chooses. */
#include "fuzz/input.h"

#include "chart/points.h"
#include "cmd/sky_rows.h"
#include "scene/sphere_file.h"

#include <stdlib.h>

static void read_spheres(const uint8_t *data, size_t size) {
    SourceFile file = {.path = (char[]){"balls.csv"}, .text = input_text(data, size)};
    float *spheres;
    int count;
    Error error;
    if (sphere_file_parse(&file, 1000, &spheres, &count, &error)) free(spheres);
    text_free(&file.text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Error error;
    if (!size) return 0;
    if (*data % 3 == 0) {
        read_spheres(data + 1, size - 1);
        return 0;
    }
    const char *path = input_file("table.csv", data + 1, size - 1);
    if (*data % 3 == 1) {
        SkyRows rows;
        if (sky_rows_read(&rows, path, &error)) sky_rows_free(&rows);
    } else {
        static Points points;
        (void)!points_read(&points, path, &error);
    }
    return 0;
}
