#include "source/text_edits.h"

#include "base/memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void text_edits_add(TextEdits *edits, size_t at, size_t size, const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    char *words = memory_get((size_t)length + 1, 1);
    vsnprintf(words, (size_t)length + 1, format, again);
    va_end(again);
    va_end(arguments);
    edits->list = memory_grow(edits->list, (size_t)edits->count + 1, sizeof *edits->list);
    edits->list[edits->count] = (TextEdit){at, size, words, edits->count};
    edits->count++;
}

static int compare(const void *first, const void *second) {
    const TextEdit *a = first, *b = second;
    if (a->at != b->at) return a->at < b->at ? -1 : 1;
    return a->order - b->order;
}

Text text_edits_apply(TextEdits *edits, const char *text) {
    Text result = {0};
    size_t at = 0;
    if (edits->count) qsort(edits->list, (size_t)edits->count, sizeof *edits->list, compare);
    for (int i = 0; i < edits->count; i++) {
        TextEdit *edit = &edits->list[i];
        if (edit->at > at) text_append(&result, text + at, edit->at - at);
        if (edit->at >= at) text_append(&result, edit->words, strlen(edit->words));
        if (edit->at > at) at = edit->at;
        if (edit->at + edit->size > at) at = edit->at + edit->size;
        free(edit->words);
    }
    text_append(&result, text + at, strlen(text + at));
    free(edits->list);
    *edits = (TextEdits){0};
    return result;
}
