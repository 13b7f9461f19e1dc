#include "base/descriptor.h"

#include "base/number.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Where standard output is. */
static int output = STDOUT_FILENO;

/* The number behind the name of a folder of descriptors. */
static int number_of(const char *path) {
    static const char *const folders[] = {"/dev/fd/", "/proc/self/fd/"};
    unsigned long long number;
    for (int i = 0; i < 2; i++) {
        size_t length = strlen(folders[i]);
        if (strncmp(path, folders[i], length) != 0) continue;
        return count_parse(path + length, &number) && number <= INT_MAX ? (int)number : -1;
    }
    return -1;
}

int descriptor_of(const char *path) {
    if (strcmp(path, "-") == 0 || strcmp(path, "/dev/stdout") == 0) return output;
    if (strcmp(path, "/dev/stderr") == 0) return STDERR_FILENO;
    int number = number_of(path);
    return number == STDOUT_FILENO ? output : number;
}

bool descriptor_is_output(const char *path) {
    return descriptor_of(path) == output;
}

void descriptor_fill_standard(void) {
    for (int number = STDIN_FILENO; number <= STDERR_FILENO; number++) {
        if (fcntl(number, F_GETFD) >= 0 || errno != EBADF) continue;
        /* The lowest number that is free is this one. */
        (void)!open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

bool descriptor_reserve_output(Error *error) {
    if (output != STDOUT_FILENO) return true;
    fflush(stdout);
    int kept = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (kept < 0)
        return error_set(error, STATUS_OUTPUT, "standard output: cannot be written: %s", strerror(errno));
    if (dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
        /* Standard error is closed. What is printed is lost, but must not go into the picture. */
        int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
    }
    output = kept;
    return true;
}
