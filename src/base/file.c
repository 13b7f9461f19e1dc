#include "base/file.h"

#include "base/descriptor.h"
#include "base/memory.h"
#include "base/regular.h"
#include "base/temporary.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* `size` is 0 where it is not known, for a stream. */
static bool file_too_large(const char *path, const FileBounds *bounds, size_t size, Error *error) {
    if (size)
        return error_set(error, bounds->status,
                         "%s: cannot be read: it has %zu bytes, and at most %zu can be", path, size,
                         bounds->most);
    return error_set(error, bounds->status, "%s: cannot be read: it has more than the %zu bytes that can be",
                     path, bounds->most);
}

/* How many bytes tell the kind of a file. */
enum { ENOUGH_TO_KNOW = 8 };

/* Appends all of an open file, `expected` bytes if it does not change meanwhile. */
static bool read_all(int descriptor, const char *path, const FileBounds *bounds, size_t expected, Text *text,
                     Error *error) {
    size_t start = text->size;
    ssize_t got = 1;
    bool asked = !bounds->begins_well;
    text_reserve(text, expected);
    while (got > 0 && text->size - start <= bounds->most) {
        char buffer[16384];
        got = read(descriptor, buffer, sizeof buffer);
        if (got < 0 && errno == EINTR)
            got = 1;
        else if (got > 0)
            text_append(text, buffer, (size_t)got);
        if (!asked && text->size - start >= ENOUGH_TO_KNOW) {
            asked = true;
            if (!bounds->begins_well(text)) return true;
        }
    }
    if (got < 0) return error_set(error, bounds->status, "%s: cannot be read: %s", path, strerror(errno));
    return text->size - start <= bounds->most || file_too_large(path, bounds, 0, error);
}

bool file_read_open(int descriptor, const char *path, const FileBounds *bounds, Text *text, Error *error) {
    struct stat found;
    size_t size = fstat(descriptor, &found) == 0 && S_ISREG(found.st_mode) ? (size_t)found.st_size : 0;
    if (size > bounds->most) return file_too_large(path, bounds, size, error);
    return read_all(descriptor, path, bounds, size, text, error);
}

bool file_read_within(const char *path, const FileBounds *bounds, Text *text, Error *error) {
    struct stat found;
    int descriptor = regular_open(path, &found, bounds->status, error);
    bool ok = descriptor >= 0 && file_read_open(descriptor, path, bounds, text, error);
    if (descriptor >= 0) close(descriptor);
    return ok;
}

bool file_read(const char *path, Status status, Text *text, Error *error) {
    return file_read_within(path, &(FileBounds){.status = status, .most = FILE_MOST}, text, error);
}

bool file_read_input(const FileBounds *bounds, Text *text, Error *error) {
    return read_all(STDIN_FILENO, "standard input", bounds, 0, text, error);
}

bool file_is_terminal(const char *path) {
    int open_already = descriptor_of(path);
    if (open_already >= 0) return isatty(open_already);
    struct stat status;
    if (stat(path, &status) != 0 || !S_ISCHR(status.st_mode)) return false;
    int descriptor = open(path, O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    bool terminal = descriptor >= 0 && isatty(descriptor);
    if (descriptor >= 0) close(descriptor);
    return terminal;
}

bool file_is_special(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode);
}

static bool output_error(const char *path, int number, Error *error) {
    return error_set(error, STATUS_OUTPUT, "%s: cannot be written: %s",
                     strcmp(path, "-") == 0 ? "standard output" : path, strerror(number));
}

/* Whether an open file takes what is written. */
static bool check_descriptor(int descriptor, const char *path, Error *error) {
    int flags = fcntl(descriptor, F_GETFL);
    if (flags < 0) return output_error(path, errno, error);
    return (flags & O_ACCMODE) != O_RDONLY || output_error(path, EBADF, error);
}

bool file_check_target(const char *path, Error *error) {
    struct stat status;
    int open_already = descriptor_of(path);
    if (open_already >= 0) return check_descriptor(open_already, path, error);
    if (stat(path, &status) == 0) {
        if (S_ISDIR(status.st_mode)) return output_error(path, EISDIR, error);
        if (access(path, W_OK) != 0) return output_error(path, errno, error);
        if (!S_ISREG(status.st_mode)) return true;
    } else if (errno != ENOENT) {
        return output_error(path, errno, error);
    }
    char *resolved = realpath(path, NULL);
    char *folder = temporary_folder(resolved ? resolved : path);
    int failed = access(folder, W_OK | X_OK) == 0 ? 0 : errno;
    free(resolved);
    free(folder);
    return failed ? output_error(path, failed, error) : true;
}

/* Writes all bytes; 0 or the errno. */
static int write_all(int descriptor, const char *data, size_t size) {
    while (size) {
        ssize_t wrote = write(descriptor, data, size);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) return errno;
        data += wrote;
        size -= (size_t)wrote;
    }
    return 0;
}

static bool (*stop_waiting)(void);

void file_set_stop(bool (*stop)(void)) {
    stop_waiting = stop;
}

/* To open a pipe waits for its reader, and a signal that asks to save and stop would not end that. */
static int open_in_place(const char *path) {
    static const struct timespec pause = {.tv_nsec = 20000000};
    struct stat status;
    bool pipe = stat(path, &status) == 0 && S_ISFIFO(status.st_mode);
    int descriptor = open(path, O_WRONLY | O_TRUNC | O_CLOEXEC | (pipe ? O_NONBLOCK : 0));
    while (descriptor < 0 && pipe && errno == ENXIO) {
        if (stop_waiting && stop_waiting()) {
            errno = EINTR;
            break;
        }
        nanosleep(&pause, NULL);
        descriptor = open(path, O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    }
    if (descriptor >= 0 && pipe) fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
    return descriptor;
}

static int write_in_place(const char *path, const void *data, size_t size) {
    int descriptor = open_in_place(path);
    if (descriptor < 0) return errno;
    int failed = write_all(descriptor, data, size);
    if (close(descriptor) != 0 && !failed) failed = errno;
    return failed;
}

/* The permissions of a file made by open(): those of the one it replaces, else what the umask leaves. */
static mode_t target_mode(const char *target) {
    struct stat status;
    if (stat(target, &status) == 0) return status.st_mode & 07777;
    mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

static int write_and_rename(const char *target, const void *data, size_t size) {
    char *temporary;
    temporary_sweep(target);
    int descriptor = temporary_make(target, &temporary);
    if (descriptor < 0) return errno;
    int failed = write_all(descriptor, data, size);
    if (!failed && fchmod(descriptor, target_mode(target)) != 0) failed = errno;
    if (!failed && fsync(descriptor) != 0) failed = errno;
    /* Renamed while it is locked: else a sweep could take it for one that was left. */
    if (!failed && rename(temporary, target) != 0) failed = errno;
    if (failed) unlink(temporary);
    close(descriptor);
    free(temporary);
    return failed;
}

/* Where a file at `path` is, or would be made: the end of its symbolic links, whether or not there is a file
 * yet. To be freed; NULL where it is `path` itself. */
static char *link_target(const char *path) {
    char *resolved = realpath(path, NULL), link[4096];
    ssize_t length = resolved ? -1 : readlink(path, link, sizeof link - 1);
    if (length <= 0) return resolved;
    link[length] = 0;
    char *folder = temporary_folder(path);
    char *target = memory_get(strlen(folder) + (size_t)length + 2, 1);
    sprintf(target, "%s%s%s", *link == '/' ? "" : folder, *link == '/' ? "" : "/", link);
    free(folder);
    return target;
}

bool file_replace(const char *path, const void *data, size_t size, Error *error) {
    int failed, open_already = descriptor_of(path);
    if (open_already >= 0) {
        failed = write_all(open_already, data, size);
    } else if (file_is_special(path)) {
        failed = write_in_place(path, data, size);
    } else {
        char *target = link_target(path);
        failed = write_and_rename(target ? target : path, data, size);
        free(target);
    }
    return failed ? output_error(path, failed, error) : true;
}
