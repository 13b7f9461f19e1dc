/* The terminal to which the program writes. */
#pragma once

/* The number of columns of the terminal behind a file descriptor; 80 if there is none. */
int terminal_columns(int descriptor);
