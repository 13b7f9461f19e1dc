/* Ctrl-C, SIGTERM and SIGHUP end the program at once, with STATUS_INTERRUPTED, while it has nothing to save.
 * Otherwise they make it stop and save, and a second one ends it at once. */
#pragma once

#include <stdbool.h>

void interrupt_install(void);

/* From now on there is something to save. */
void interrupt_keep(void);
bool interrupt_requested(void);

/* Ends the program although another thread is in the middle of something: with STATUS_INTERRUPTED if it was
 * interrupted, and else well. */
_Noreturn void interrupt_leave(bool interrupted);
