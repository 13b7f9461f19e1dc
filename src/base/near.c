#include "base/near.h"

#include "base/memory.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static size_t least(size_t a, size_t b) {
    return a < b ? a : b;
}

static size_t word_distance(const char *a, size_t a_length, const char *b) {
    size_t b_length = strlen(b), width = b_length + 1;
    size_t *table = memory_get((a_length + 1) * width, sizeof *table);
    for (size_t i = 0; i <= a_length; i++) {
        for (size_t k = 0; k <= b_length; k++) {
            size_t *cell = table + i * width + k;
            if (!i || !k) {
                *cell = i + k;
                continue;
            }
            *cell = least(*(cell - width), *(cell - 1)) + 1;
            *cell = least(*cell, *(cell - width - 1) + (a[i - 1] != b[k - 1]));
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
                *cell = least(*cell, *(cell - 2 * width - 2) + 1);
        }
    }
    size_t distance = table[a_length * width + b_length];
    free(table);
    return distance;
}

Near near_to(const char *word, size_t length) {
    return (Near){.word = word, .length = length, .distance = SIZE_MAX};
}

void near_try(Near *near, const char *name) {
    size_t distance = word_distance(near->word, near->length, name);
    if (distance > strlen(name + strspn(name, "-")) / 3 || distance > near->distance) return;
    /* Of two that are as near, the longer one: letters are left out more often than added. */
    if (distance == near->distance && strlen(name) <= strlen(near->name)) return;
    near->name = name;
    near->distance = distance;
}
