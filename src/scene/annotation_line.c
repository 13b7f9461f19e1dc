#include "scene/annotation_line.h"

#include "base/memory.h"
#include "base/number.h"
#include "base/text.h"
#include "scene/setting.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool line_cut(Line *line, char *text, Error *error) {
    line->count = 0;
    for (text += strspn(text, " \t\r"); *text; text += strspn(text, " \t\r")) {
        if (line->count == MOST_WORDS)
            return error_set(error, STATUS_SCENE, "more than %d words", MOST_WORDS);
        char *end;
        if (*text == '"') {
            end = strchr(++text, '"');
            if (!end) return error_set(error, STATUS_SCENE, "the quotation mark is not closed");
        } else {
            end = text + strcspn(text, " \t\r");
        }
        line->words[line->count++] = text;
        text = end + (*end != 0);
        *end = 0;
    }
    return true;
}

bool line_once(Line *line, const char *key, Error *error) {
    LineSeen *seen = line->seen;
    for (int i = 0; i < seen->count; i++) {
        if (strcmp(seen->items[i].key, key) != 0) continue;
        return error_set(error, STATUS_SCENE, "%s is there already, in line %d", key, seen->items[i].number);
    }
    seen->items = memory_grow(seen->items, (size_t)seen->count + 1, sizeof *seen->items);
    LineOnce *once = &seen->items[seen->count++];
    *once = (LineOnce){.number = line->number};
    snprintf(once->key, sizeof once->key, "%s", key);
    return true;
}

bool line_has(const Line *line, const char *key) {
    for (int i = 0; i < line->seen->count; i++) {
        if (strcmp(line->seen->items[i].key, key) == 0) return true;
    }
    return false;
}

void line_seen_free(LineSeen *seen) {
    free(seen->items);
    *seen = (LineSeen){0};
}

bool line_end(const Line *line, int at, Error *error) {
    return at >= line->count ||
           error_set(error, STATUS_SCENE, "%s: '%s' is one word too many", line->words[0], line->words[at]);
}

char *line_join(const Line *line, int first) {
    Text joined = {0};
    text_append(&joined, "", 0);
    for (int i = first; i < line->count; i++)
        text_print(&joined, "%s%s", i > first ? " " : "", line->words[i]);
    return joined.data;
}

bool line_copy_word(char *target, size_t size, const char *word, Error *error) {
    if (strlen(word) >= size)
        return error_set(error, STATUS_SCENE, "'%s' has more than %zu characters", word, size - 1);
    memcpy(target, word, strlen(word) + 1);
    return true;
}

static bool has_words(const Line *line, int at, int count, Error *error) {
    if (at + count <= line->count) return true;
    return error_set(error, STATUS_SCENE, "%s needs %d number%s", line->words[at - 1], count,
                     count > 1 ? "s" : "");
}

bool line_numbers(const Line *line, int at, int count, double min, double max, double *values, Error *error) {
    if (!has_words(line, at, count, error)) return false;
    for (int i = 0; i < count; i++) {
        if (!number_parse_range(line->words[at - 1], line->words[at + i], min, max, &values[i], error))
            return false;
    }
    return true;
}

bool line_setting(const Line *line, int at, int count, const char *setting, Error *error) {
    Text value = {0};
    if (!has_words(line, at, count, error)) return false;
    for (int i = 0; i < count; i++) text_print(&value, "%s%s", i ? "," : "", line->words[at + i]);
    bool ok = setting_apply(line->file, &line->file->values, setting, text_string(&value), error);
    text_free(&value);
    return ok;
}
