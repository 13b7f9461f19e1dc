/* Faults of files that somebody else made: each is refused by one clear line, at once and with little memory.
 */
#pragma once

#include "support.h"

/* How much more the sanitizers take, and how long the texts are that would take long: the sanitizers measure
 * a text whenever a part of it is compared. */
#ifdef __SANITIZE_ADDRESS__
enum { FAULT_SLOWER = 10, FAULT_SIZE = 50000 };
#else
enum { FAULT_SLOWER = 1, FAULT_SIZE = 1000000 };
#endif

/* Runs `magichour ARGUMENTS` and expects the exit status and, in the one line that it says, the part. It has
 * to end within 10 seconds, and to take less than one second of the processor and 200 MB. Under sanitizers it
 * may take ten times as much. */
void fault_expect(int status, const char *part, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The same for shell words in front of the program, such as "ulimit -v 100000;", and in place of its standard
 * input "</dev/null". */
void fault_expect_in(const char *shell, int status, const char *part, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Expects success within the same bounds, whatever is said. */
void fault_cheap(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Runs a shell command with support_path("") in $D and the program in $M; gives its exit status, and what it
 * said in support_err. */
int fault_shell(const char *format, ...) __attribute__((format(printf, 1, 2)));
