#include "base/regular.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

/* Why this kind of file is not read; NULL for a regular one. */
static const char *other_kind(mode_t mode) {
    if (S_ISREG(mode)) return NULL;
    if (S_ISDIR(mode)) return strerror(EISDIR);
    if (S_ISFIFO(mode)) return "a pipe, and no regular file";
    if (S_ISSOCK(mode)) return "a socket, and no regular file";
    return "a device, and no regular file";
}

int regular_open(const char *path, struct stat *found, Status status, Error *error) {
    /* To open a device may already change it. */
    const char *reason = stat(path, found) != 0 ? strerror(errno) : other_kind(found->st_mode);
    int descriptor = -1;
    if (!reason) {
        /* The name may be another file's by now: to open a pipe must not wait for its writer. */
        descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
        reason =
            descriptor < 0 || fstat(descriptor, found) != 0 ? strerror(errno) : other_kind(found->st_mode);
    }
    if (!reason) return descriptor;
    if (descriptor >= 0) close(descriptor);
    error_set(error, status, "%s: cannot be read: %s", path, reason);
    return -1;
}
