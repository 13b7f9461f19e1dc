#include "cmd/interrupt.h"

#include "base/clock.h"
#include "base/error.h"
#include "base/file.h"

#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <unistd.h>

static volatile sig_atomic_t requested, keeps, line;
static double first_seconds;
static const char clear_line[] = "\r\033[K";

/* A second signal takes its default course, but not one that comes at once: `timeout` sends its signal both
 * to the program and to its group. */
static void handle(int signal_number) {
    double now = clock_seconds();
    if (!keeps) {
        /* The shell's prompt would follow the unfinished line. */
        if (line && write(STDERR_FILENO, clear_line, sizeof clear_line - 1) < 0) _exit(STATUS_INTERRUPTED);
        _exit(STATUS_INTERRUPTED);
    }
    if (requested && now > first_seconds + 0.3) {
        signal(signal_number, SIG_DFL);
        raise(signal_number);
    }
    if (!requested) first_seconds = now;
    requested = 1;
}

void interrupt_install(void) {
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action = {.sa_handler = handle, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    for (int i = 0; i < 3; i++) sigaddset(&action.sa_mask, signals[i]);
    for (int i = 0; i < 3; i++) sigaction(signals[i], &action, NULL);
    /* Nobody reads the progress any more: that must not lose the picture. */
    signal(SIGPIPE, SIG_IGN);
    file_set_stop(interrupt_requested);
}

void interrupt_keep(void) {
    keeps = 1;
}

void interrupt_line(bool open) {
    line = open;
}

bool interrupt_requested(void) {
    return requested != 0;
}

_Noreturn void interrupt_leave(bool interrupted) {
    fflush(NULL);
    _exit(interrupted ? STATUS_INTERRUPTED : STATUS_DONE);
}

bool interrupt_forgive(bool ok, Error *error) {
    if (ok || error->status != STATUS_INTERRUPTED) return ok;
    *error = (Error){.status = STATUS_DONE};
    return true;
}
