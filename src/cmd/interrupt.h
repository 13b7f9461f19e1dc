/* Ctrl-C, SIGTERM and SIGHUP ask a rendering to stop and save; a second one ends the program at once. */
#pragma once

#include <stdbool.h>

void interrupt_install(void);
bool interrupt_requested(void);
