/* A terminal of the test's own, to which the program may write. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct Terminal {
    int master, kept;
    /* As the shell opens it: 2>NAME. */
    char name[128];
} Terminal;

/* Opens a terminal of so many columns; skips the test where there is none. */
void terminal_open(Terminal *terminal, int columns);

/* What was written since, at most `size` - 1 characters, and a zero. What is not read waits up to 4096
 * characters and then stops the writer. */
size_t terminal_read(const Terminal *terminal, char *text, size_t size);

/* Types at the terminal. */
void terminal_type(const Terminal *terminal, const char *keys);

/* Reads until the words have come, for so many seconds at most; gives whether they have. `text` is all that
 * was written, cut to its size. */
bool terminal_await(const Terminal *terminal, const char *words, double seconds, char *text, size_t size);
void terminal_close(Terminal *terminal);
