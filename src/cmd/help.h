/* Help and the manual page, both made from the table of options. */
#pragma once

#include "base/text.h"
#include "cmd/options.h"

/* The help of a command, or of the program (COMMAND_NONE), in lines of at most `columns` (48 at least). */
void help_print(Command command, int columns, Text *out);

/* The manual page magichour(1), in the macros of man(7). */
void help_print_manual(Text *out);
