#include "cmd/interrupt.h"

#include "base/clock.h"
#include "base/error.h"
#include "base/file.h"
#include "gl/program.h"

#include <math.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

static volatile sig_atomic_t requested, keeps, line, picture;
static double first_seconds, compile_seconds;
static char too_long[640];
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

static void ask_for_picture(int signal_number) {
    (void)signal_number;
    picture = 1;
}

void interrupt_answer(void) {
    struct sigaction action = {.sa_handler = ask_for_picture, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    sigaction(SIGUSR1, &action, NULL);
}

bool interrupt_picture_asked(void) {
    return picture != 0;
}

void interrupt_picture_done(void) {
    picture = 0;
}

void interrupt_keep(void) {
    keeps = 1;
}

void interrupt_saved(void) {
    keeps = 0;
}

/* Only what may be called in a handler. */
static void end_compiling(int signal_number) {
    (void)signal_number;
    if (keeps) return;
    if (line && write(STDERR_FILENO, clear_line, sizeof clear_line - 1) < 0) _exit(STATUS_SCENE);
    if (write(STDERR_FILENO, too_long, strlen(too_long)) < 0) _exit(STATUS_SCENE);
    _exit(STATUS_SCENE);
}

/* The timer counts the processor time of all threads, of which only one compiles. */
static void watch_compiling(bool compiling) {
    struct itimerval timer = {0};
    double seconds = compiling ? compile_seconds : 0;
    timer.it_value.tv_sec = (time_t)seconds;
    timer.it_value.tv_usec = (suseconds_t)((seconds - floor(seconds)) * 1e6);
    setitimer(ITIMER_PROF, &timer, NULL);
}

void interrupt_limit_compiling(double seconds, const char *scene) {
    struct sigaction action = {.sa_handler = end_compiling, .sa_flags = SA_RESTART};
    compile_seconds = seconds;
    snprintf(too_long, sizeof too_long,
             "magichour: %.400s: the driver has compiled a shader for %g s of processor time and is not done "
             "(--compile-time): make the scene's functions smaller, or call them less often\n",
             scene, seconds);
    sigemptyset(&action.sa_mask);
    sigaction(SIGPROF, &action, NULL);
    program_set_watch(watch_compiling);
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
