#include "faults.h"

#include "base/file.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct Cost {
    int status;
    double seconds;
    long kilobytes;
} Cost;

static double seconds_of(struct timeval time) {
    return (double)time.tv_sec + 1e-6 * (double)time.tv_usec;
}

/* Runs a command by the shell, which does not outlive it. */
static Cost run(const char *command) {
    struct rusage usage;
    int status;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    assert_int_equal(wait4(child, &status, 0, &usage), child);
    return (Cost){.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
                  .seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
                  .kilobytes = usage.ru_maxrss};
}

static void read_said(void) {
    Text said = {0};
    Error error;
    if (!file_read(support_path("said"), STATUS_FAILURE, &said, &error)) fail_msg("%s", error.text);
    snprintf(support_err, sizeof support_err, "%s", text_string(&said));
    text_free(&said);
}

static const char *program(void) {
    const char *named = getenv("MAGICHOUR");
    return named ? named : "build/magichour";
}

/* Runs the program within the bounds, which are more than it may take. */
static Cost run_program(const char *shell, const char *arguments) {
    char command[4096];
    snprintf(command, sizeof command, "%s exec timeout %d '%s' %s >'%s' 2>'%s' </dev/null", shell,
             10 * FAULT_SLOWER, program(), arguments, support_path("stdout"), support_path("said"));
    Cost cost = run(command);
    read_said();
    if (cost.seconds > 1.0 * FAULT_SLOWER || cost.kilobytes > 200000L * FAULT_SLOWER)
        fail_msg("'%s': %.2f s and %ld kB", arguments, cost.seconds, cost.kilobytes);
    return cost;
}

static void expect(const char *shell, int status, const char *part, const char *format, va_list list) {
    char arguments[2048];
    vsnprintf(arguments, sizeof arguments, format, list);
    int got = run_program(shell, arguments).status;
    const char *end = strchr(support_err, '\n');
    bool one_line = end && !end[1] && strncmp(support_err, "magichour: ", 11) == 0;
    if (got != status || !one_line || !strstr(support_err, part))
        fail_msg("'%s': expected status %d and one line with '%s', got %d and: %s", arguments, status, part,
                 got, support_err);
}

void fault_cheap(const char *format, ...) {
    va_list list;
    char arguments[2048];
    va_start(list, format);
    vsnprintf(arguments, sizeof arguments, format, list);
    va_end(list);
    int got = run_program("", arguments).status;
    if (got != 0) fail_msg("'%s': status %d and: %s", arguments, got, support_err);
}

void fault_expect(int status, const char *part, const char *format, ...) {
    va_list list;
    va_start(list, format);
    expect("", status, part, format, list);
    va_end(list);
}

void fault_expect_in(const char *shell, int status, const char *part, const char *format, ...) {
    va_list list;
    va_start(list, format);
    expect(shell, status, part, format, list);
    va_end(list);
}

int fault_shell(const char *format, ...) {
    va_list list;
    char words[2048], command[4096], folder[1024];
    va_start(list, format);
    vsnprintf(words, sizeof words, format, list);
    va_end(list);
    snprintf(folder, sizeof folder, "%s", support_path(""));
    snprintf(command, sizeof command, "D='%s' M='%s'; { %s ; } 2>'%s' </dev/null", folder, program(), words,
             support_path("said"));
    int status = run(command).status;
    read_said();
    return status;
}
