/* Measurements in a CSV that grows row by row, so that an interrupted chart goes on where it was.
 *
 *     # magichour 0.1.0           lines of what was measured, and on what: the identity
 *     sky,light,samples,seconds   names of the words, then of the numbers
 *     table:gauss:8,cosine,1,0.01
 */
#pragma once

#include "base/text.h"

enum { LEDGER_WORDS = 4, LEDGER_NUMBERS = 4 };

typedef struct LedgerRow {
    char words[LEDGER_WORDS][48];
    double numbers[LEDGER_NUMBERS];
} LedgerRow;

typedef struct Ledger {
    char *path;
    int word_count, number_count;
    Text head; /* the identity and the columns' names, as they stand in the file */
    LedgerRow *rows;
    int count;
} Ledger;

/* Reads the CSV at `path` if it is there and begins with this identity (lines that start with #) and these
 * columns ("a,b,c": words first). One that begins otherwise is renamed to PATH.old, and `set_aside` says why;
 * else that stays as it is. A row that is not whole, as the last of a program that was killed, is dropped. */
MUST_CHECK bool ledger_open(Ledger *ledger, const char *path, const char *identity, int word_count,
                            const char *columns, Text *set_aside, Error *error);
void ledger_close(Ledger *ledger);

/* Adds a row, in the file too. Unused words and numbers are ignored. */
MUST_CHECK bool ledger_add(Ledger *ledger, const LedgerRow *row, Error *error);

/* Drops all rows with these words, in the file too. */
MUST_CHECK bool ledger_drop(Ledger *ledger, const LedgerRow *like, Error *error);

/* Whether a row has these words. */
bool ledger_same(const Ledger *ledger, const LedgerRow *row, const LedgerRow *like);
