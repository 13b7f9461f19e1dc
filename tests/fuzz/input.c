#define _GNU_SOURCE /* memmem */
#include "fuzz/input.h"

#include "base/budget.h"
#include "image/format.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[256];

static void remove_folder(void) {
    char command[300];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    if (system(command) != 0) fputs("a folder is left\n", stderr);
}

static void make_folder(void) {
    /* In memory, where there is such a place. */
    const char *base = access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp";
    if (*folder) return;
    snprintf(folder, sizeof folder, "%s/magichour_fuzz_XXXXXX", base);
    if (!mkdtemp(folder)) abort();
    atexit(remove_folder);
}

const char *input_file(const char *name, const uint8_t *data, size_t size) {
    static char paths[8][512];
    static int next;
    char *path = paths[next++ % 8];
    make_folder();
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(data, 1, size, file) != size || fclose(file) != 0) abort();
    return path;
}

void input_folder(const char *name) {
    char path[512];
    make_folder();
    snprintf(path, sizeof path, "%s/%s", folder, name);
    mkdir(path, 0700);
}

size_t input_part(const uint8_t **data, size_t *size, const uint8_t **part) {
    static const char mark[] = "\n===\n";
    const uint8_t *found = *size ? memmem(*data, *size, mark, sizeof mark - 1) : NULL;
    size_t length = found ? (size_t)(found - *data) + 1 : *size;
    size_t skipped = found ? length + sizeof mark - 2 : *size;
    *part = *data;
    *data += skipped;
    *size -= skipped;
    return length;
}

Text input_text(const uint8_t *data, size_t size) {
    Text text = {0};
    text_append(&text, data, size);
    return text;
}

void input_picture(const uint8_t *data, size_t size, InputDecoder *decode) {
    Text file = input_text(data, size), said = {0}, value = {0};
    Image image;
    Error error;
    /* Little, so that what is within the bounds is quick. */
    budget_set(32 << 20);
    if (decode(&image, "fuzz", &file, &(ImageReadParams){.said = &said}, &error)) image_free(&image);
    (void)!image_attribute(&file, "magichour.command", &value);
    budget_give((size_t)-1);
    text_free(&value);
    text_free(&said);
    text_free(&file);
}
