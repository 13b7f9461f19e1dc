#include "cmd/interrupt.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t requested;

static void handle(int signal_number) {
    (void)signal_number;
    requested = 1;
}

void interrupt_install(void) {
    /* SA_RESETHAND: the second signal takes its default course. */
    struct sigaction action = {.sa_handler = handle, .sa_flags = SA_RESTART | (int)SA_RESETHAND};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
}

bool interrupt_requested(void) {
    return requested != 0;
}
