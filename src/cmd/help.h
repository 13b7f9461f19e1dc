/* The help, which is made from the table of options. */
#pragma once

#include "base/text.h"
#include "cmd/options.h"

/* Writes the help of a command, or of the program for COMMAND_NONE, in lines of at most `columns` characters
 * (48 or more). */
void help_print(Command command, int columns, Text *out);
