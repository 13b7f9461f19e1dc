/* The manual page, which is made from the table of options as the help is. */
#pragma once

#include "base/text.h"

/* Writes the manual page magichour(1) in the macros of man(7). */
void manual_print(Text *out);
