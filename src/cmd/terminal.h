/* The terminal that the program writes to. */
#pragma once

/* Columns of the terminal behind a file descriptor; 80 where there is none. */
int terminal_columns(int descriptor);
