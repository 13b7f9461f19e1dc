#include "failed.h"

#include "support.h"

#include "image/format.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static void write(const char *folder, const char *name, const char *extension, const Image *image) {
    char path[512];
    Error error;
    ImageWriteParams params = {0};
    snprintf(path, sizeof path, "%s/%s.%s", folder, name, extension);
    if (!image_write(image, path, &params, &error)) print_message("%s\n", error.text);
}

static double mean_of(const Image *image) {
    double sum = 0;
    int values = 3 * image->width * image->height;
    for (int i = 0; i < values; i++) sum += (double)image->rgba[4 * (i / 3) + i % 3];
    return values ? sum / values : 0;
}

static Image error_of(const Image *got, const Image *wanted, bool shown) {
    Image error = image_create(got->width, got->height);
    double mean = mean_of(wanted);
    for (int i = 0; i < 4 * got->width * got->height; i++) {
        float difference = got->rgba[i] - wanted->rgba[i];
        error.rgba[i] = i % 4 == 3 ? 1
                        : !shown   ? difference
                                   : fabsf(difference) * (float)(mean > 0 ? 5 / mean : 1);
    }
    return error;
}

void failed_keep(const char *name, const Image *got, const Image *wanted) {
    char folder[384];
    int length = snprintf(folder, sizeof folder, "out/failed/%.300s", name);
    for (int i = (int)sizeof "out/failed"; i < length; i++)
        if (!isalnum((unsigned char)folder[i]) && !strchr(".,_=-", folder[i])) folder[i] = '-';
    mkdir("out", 0777);
    mkdir("out/failed", 0777);
    mkdir(folder, 0777);
    const Image *pictures[] = {got, wanted};
    for (int i = 0; i < 4; i++)
        write(folder, i / 2 ? "wanted" : "got", i % 2 ? "png" : "exr", pictures[i / 2]);
    if (got->width == wanted->width && got->height == wanted->height) {
        for (int i = 0; i < 2; i++) {
            Image error = error_of(got, wanted, i);
            write(folder, "error", i ? "png" : "exr", &error);
            image_free(&error);
        }
    }
    print_message("pictures kept in %s: got, wanted, error\n", folder);
}
