/* Open files by the names that people give them: "-" and "/dev/stdout" are standard output, "/dev/fd/3" is
 * what the shell opened with 3>. To open such a name anew would empty the file behind it, or replace it. */
#pragma once

#include "base/error.h"

/* The descriptor that a path to be written names; -1 if it is the path of a file. */
int descriptor_of(const char *path);

/* Whether the path names standard output. */
bool descriptor_is_output(const char *path);

/* Opens /dev/null in place of standard input, output and error where they are closed, so that no file of the
 * program's gets their numbers, and messages in it. To read or to write there still fails. */
void descriptor_fill_standard(void);

/* From now on standard output belongs to what is written to the descriptor alone: all that is printed goes to
 * standard error, by whichever library. Fails with STATUS_OUTPUT if standard output is closed. */
MUST_CHECK bool descriptor_reserve_output(Error *error);
