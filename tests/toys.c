#include "toys.h"

#include "base/file.h"
#include "image/tone.h"

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char folder[] = "tests/data/toys";

const char *toys_next(void) {
    static struct dirent **entries;
    static int count, at;
    static char path[300];
    if (!entries) count = scandir(folder, &entries, NULL, alphasort), at = 0;
    for (; at < count; at++) {
        if (!strstr(entries[at]->d_name, ".glsl")) continue;
        snprintf(path, sizeof path, "%s/%s", folder, entries[at++]->d_name);
        return path;
    }
    for (int i = 0; i < count; i++) free(entries[i]);
    free(entries);
    entries = NULL;
    return NULL;
}

bool toys_line(const char *path, const char *kind, int number, char *words, size_t size) {
    Text text = {0};
    Error error;
    char mark[40];
    bool found = false;
    snprintf(mark, sizeof mark, "// %s ", kind);
    if (!file_read(path, STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    for (const char *at = text_string(&text); !found && (at = strstr(at, mark)); at++) {
        if (number-- > 0) continue;
        snprintf(words, size, "%.*s", (int)strcspn(at + strlen(mark), "\n"), at + strlen(mark));
        found = true;
    }
    text_free(&text);
    return found;
}

int toys_check(const char *path, const Image *image) {
    char words[300];
    int count = 0;
    for (; toys_line(path, "expect", count, words, sizeof words); count++) {
        int x, y, wanted[3];
        if (sscanf(words, "%d %d: %d %d %d", &x, &y, &wanted[0], &wanted[1], &wanted[2]) != 5)
            fail_msg("%s: expect %s", path, words);
        const float *rgb = image->rgba + 4 * ((image->height - 1 - y) * image->width + x);
        for (int c = 0; c < 3; c++) {
            double level = tone_level(image->shown ? TONE_NONE : TONE_SCREEN, 1, (double)rgb[c]);
            if (fabs(level - wanted[c]) > 1.01)
                fail_msg("%s: pixel %d %d, channel %d: %g, not %d", path, x, y, c, level, wanted[c]);
        }
    }
    return count;
}
