/* Ctrl-C, SIGTERM and SIGHUP make a rendering stop and save. A second one ends the program at once. */
#pragma once

#include <stdbool.h>

void interrupt_install(void);
bool interrupt_requested(void);
