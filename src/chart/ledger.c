#include "chart/ledger.h"

#include "base/file.h"
#include "base/lines.h"
#include "base/memory.h"
#include "base/number.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void row_print(const Ledger *ledger, const LedgerRow *row, Text *out) {
    for (int i = 0; i < ledger->word_count; i++) text_print(out, "%s%s", i ? "," : "", row->words[i]);
    for (int i = 0; i < ledger->number_count; i++) text_print(out, ",%.6g", row->numbers[i]);
    text_print(out, "\n");
}

/* Reads a line, and cuts it at its commas in place. Returns false if it is not a complete row. */
static bool row_read(const Ledger *ledger, char *line, LedgerRow *row) {
    *row = (LedgerRow){0};
    for (int i = 0; i < ledger->word_count + ledger->number_count; i++) {
        if (!line) return false;
        char *comma = strchr(line, ',');
        if (comma) *comma = 0;
        int number = i - ledger->word_count;
        if (number < 0) {
            snprintf(row->words[i], sizeof row->words[i], "%s", line);
        } else if (!number_parse(line, &row->numbers[number])) {
            return false;
        }
        line = comma ? comma + 1 : NULL;
    }
    return !line;
}

static void rows_push(Ledger *ledger, const LedgerRow *row) {
    ledger->rows = memory_grow(ledger->rows, (size_t)ledger->count + 1, sizeof *ledger->rows);
    ledger->rows[ledger->count++] = *row;
}

static bool rewrite(const Ledger *ledger, Error *error) {
    Text out = {0};
    text_append(&out, ledger->head.data, ledger->head.size);
    for (int i = 0; i < ledger->count; i++) row_print(ledger, &ledger->rows[i], &out);
    bool ok = file_replace(ledger->path, out.data, out.size, error);
    text_free(&out);
    return ok;
}

/* Prints the first line of `there` that differs from `here`, in words. */
static void say_difference(const char *path, const char *there, const char *here, Text *out) {
    Lines old = lines_of(there), new = lines_of(here);
    const char *a, *b;
    do {
        a = lines_next(&old);
        b = lines_next(&new);
    } while (a && b && strcmp(a, b) == 0);
    text_print(out, "%s: its line '%s' is '%s' now: set aside as %s.old\n", path, a ? a : "", b ? b : "",
               path);
    lines_free(&old);
    lines_free(&new);
}

/* Reads the rows of a file that has the right beginning. */
static void take_rows(Ledger *ledger, const char *text) {
    Lines lines = lines_of(text);
    for (char *line; (line = lines_next(&lines));) {
        LedgerRow row;
        if (lines.ended && row_read(ledger, line, &row)) rows_push(ledger, &row);
    }
    lines_free(&lines);
}

static bool set_file_aside(const char *path, Error *error) {
    Text old = {0};
    text_print(&old, "%s.old", path);
    int failed = rename(path, text_string(&old));
    text_free(&old);
    return !failed || error_set(error, STATUS_OUTPUT, "%s: cannot be renamed: %s", path, strerror(errno));
}

bool ledger_open(Ledger *ledger, const char *path, const char *identity, int word_count, const char *columns,
                 Text *set_aside, Error *error) {
    Text file = {0};
    bool ok = true;
    *ledger = (Ledger){.path = memory_string(path), .word_count = word_count, .number_count = 1 - word_count};
    for (const char *c = columns; *c; c++) ledger->number_count += *c == ',';
    text_print(&ledger->head, "%s%s\n", identity, columns);
    if (access(path, F_OK) == 0) {
        ok = lines_read(path, STATUS_OUTPUT, &file, error);
        if (ok && strncmp(text_string(&file), ledger->head.data, ledger->head.size) == 0) {
            take_rows(ledger, file.data + ledger->head.size);
        } else if (ok) {
            say_difference(path, text_string(&file), ledger->head.data, set_aside);
            ok = set_file_aside(path, error);
        }
    }
    text_free(&file);
    if (ok && rewrite(ledger, error)) return true;
    ledger_close(ledger);
    return false;
}

void ledger_close(Ledger *ledger) {
    free(ledger->path);
    free(ledger->rows);
    text_free(&ledger->head);
    *ledger = (Ledger){0};
}

bool ledger_add(Ledger *ledger, const LedgerRow *row, Error *error) {
    Text line = {0};
    row_print(ledger, row, &line);
    FILE *file = fopen(ledger->path, "ab");
    bool ok = file && fwrite(line.data, 1, line.size, file) == line.size;
    if (file) ok = fclose(file) == 0 && ok;
    text_free(&line);
    if (!ok)
        return error_set(error, STATUS_OUTPUT, "%s: cannot be written: %s", ledger->path, strerror(errno));
    rows_push(ledger, row);
    return true;
}

bool ledger_same(const Ledger *ledger, const LedgerRow *row, const LedgerRow *like) {
    for (int i = 0; i < ledger->word_count; i++) {
        if (strcmp(row->words[i], like->words[i]) != 0) return false;
    }
    return true;
}

bool ledger_drop(Ledger *ledger, const LedgerRow *like, Error *error) {
    int kept = 0;
    for (int i = 0; i < ledger->count; i++) {
        if (!ledger_same(ledger, &ledger->rows[i], like)) ledger->rows[kept++] = ledger->rows[i];
    }
    if (kept == ledger->count) return true;
    ledger->count = kept;
    return rewrite(ledger, error);
}
