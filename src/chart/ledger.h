/* Measurements in a CSV that grows row by row. An interrupted chart goes on where it stopped.
 *
 *     # magichour VERSION         the identity: what was measured, and on which machine
 *     sky,light,samples,seconds   the names of the words, then of the numbers
 *     table:gauss:8,cosine,1,0.01
 */
#pragma once

#include "base/text.h"

enum { LEDGER_WORDS = 5, LEDGER_NUMBERS = 4 };

typedef struct LedgerRow {
    char words[LEDGER_WORDS][48];
    double numbers[LEDGER_NUMBERS];
} LedgerRow;

typedef struct Ledger {
    char *path;
    int word_count, number_count;
    /* The identity and the columns' names, as they stand in the file. */
    Text head;
    LedgerRow *rows;
    int count;
} Ledger;

/* Opens the CSV at `path`. `identity` is lines that start with #, and `columns` is "a,b,c", words first.
 *
 * If the file begins with this identity and these columns, its rows are read. If it begins differently, it is
 * renamed to PATH.old, and `set_aside` gets the reason. Incomplete rows are dropped, such as the last row of
 * a program that was killed. */
MUST_CHECK bool ledger_open(Ledger *ledger, const char *path, const char *identity, int word_count,
                            const char *columns, Text *set_aside, Error *error);
void ledger_close(Ledger *ledger);

/* Adds a row, also to the file. Words and numbers beyond the columns are ignored. */
MUST_CHECK bool ledger_add(Ledger *ledger, const LedgerRow *row, Error *error);

/* Drops all rows with the words of `like`, also from the file. */
MUST_CHECK bool ledger_drop(Ledger *ledger, const LedgerRow *like, Error *error);

/* Says whether a row has the words of `like`. */
bool ledger_same(const Ledger *ledger, const LedgerRow *row, const LedgerRow *like);
