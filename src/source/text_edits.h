/* Changes of a text that are collected by their places and made at once. */
#pragma once

#include "base/text.h"

typedef struct TextEdit {
    /* Takes `size` bytes away at `at` and puts `words` there; owned. */
    size_t at, size;
    char *words;
    /* Edits at the same place are made in the order in which they were added. */
    int order;
} TextEdit;

/* A zeroed list is empty. */
typedef struct TextEdits {
    TextEdit *list;
    int count;
} TextEdits;

void text_edits_add(TextEdits *edits, size_t at, size_t size, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Makes the changes in a copy of `text`, empties the list, and returns the copy. An edit within what another
 * has taken away before is left out. */
Text text_edits_apply(TextEdits *edits, const char *text);
