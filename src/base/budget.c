#include "base/budget.h"

#include <stdint.h>
#include <stdio.h>

static size_t budget, taken;

void budget_set(size_t bytes) {
    budget = bytes;
}

size_t budget_left(size_t usual) {
    if (!budget) return usual;
    return budget > taken ? budget - taken : 0;
}

bool budget_take(size_t bytes, size_t usual, Status status, const char *what, Error *error) {
    size_t left = budget_left(usual);
    if (bytes <= left) {
        taken += budget ? bytes : 0;
        return true;
    }
    return error_set(
        error, status, "%s needs %s of memory, and %s are allowed%s (--max-memory SIZE allows more)", what,
        bytes_up(bytes).text, bytes_down(left).text, budget && taken ? " besides what is in use" : "");
}

void budget_give(size_t bytes) {
    taken -= bytes < taken ? bytes : taken;
}

static ByteWords words(size_t kibibytes, size_t mebibytes) {
    ByteWords words;
    if (mebibytes < 10)
        snprintf(words.text, sizeof words.text, "%zu KiB", kibibytes);
    else
        snprintf(words.text, sizeof words.text, "%zu MiB", mebibytes);
    return words;
}

ByteWords bytes_up(size_t bytes) {
    return words((bytes >> 10) + (bytes % 1024 > 0), (bytes >> 20) + (bytes % (1 << 20) > 0));
}

ByteWords bytes_down(size_t bytes) {
    return words(bytes >> 10, bytes >> 20);
}
