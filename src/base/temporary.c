#include "base/temporary.h"

#include "base/memory.h"
#include "base/text.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static const char unknown[] = "XXXXXX";

char *temporary_folder(const char *path) {
    const char *slash = strrchr(path, '/');
    if (!slash) return memory_string(".");
    return slash == path ? memory_string("/") : memory_string_part(path, (size_t)(slash - path));
}

/* What the names of all temporary files of this target begin with. It is not the target's name and more: that
 * may be as long as names can be. */
static void print_stem(Text *text, const char *target) {
    const char *slash = strrchr(target, '/');
    uint64_t hash = 0xcbf29ce484222325; /* FNV-1a */
    for (const char *c = slash ? slash + 1 : target; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 0x100000001b3;
    text_print(text, ".magichour-%016llx-", (unsigned long long)hash);
}

/* Locks a file of which nobody else has the descriptor; false where a sweep was quicker, and removes it. */
static bool lock_new(int descriptor) {
    struct stat status;
    /* Where there are no locks, nobody else has one either. */
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
    return fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

int temporary_make(const char *target, char **path) {
    char *folder = temporary_folder(target);
    int descriptor = -1;
    *path = NULL;
    do {
        Text name = {0};
        text_print(&name, "%s/", folder);
        print_stem(&name, target);
        text_print(&name, "%s", unknown);
        if (descriptor >= 0) close(descriptor);
        free(*path);
        *path = name.data;
        descriptor = mkstemp(*path);
        if (descriptor >= 0) fcntl(descriptor, F_SETFD, FD_CLOEXEC);
    } while (descriptor >= 0 && !lock_new(descriptor));
    int failed = errno;
    free(folder);
    if (descriptor < 0) free(*path), *path = NULL;
    errno = failed;
    return descriptor;
}

/* Whether the open file is one that temporary_make() has made, still has this name, and has no writer. */
static bool is_left(int folder, const char *name, int descriptor) {
    struct stat open_file, named;
    return fstat(descriptor, &open_file) == 0 && S_ISREG(open_file.st_mode) &&
           open_file.st_uid == geteuid() && open_file.st_nlink == 1 &&
           flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
           fstatat(folder, name, &named, AT_SYMLINK_NOFOLLOW) == 0 && named.st_dev == open_file.st_dev &&
           named.st_ino == open_file.st_ino;
}

void temporary_sweep(const char *target) {
    char *path = temporary_folder(target);
    DIR *folder = opendir(path);
    Text stem = {0};
    print_stem(&stem, target);
    for (struct dirent *entry; folder && (entry = readdir(folder));) {
        if (strncmp(entry->d_name, stem.data, stem.size) != 0 ||
            strlen(entry->d_name) != stem.size + sizeof unknown - 1)
            continue;
        int descriptor = openat(dirfd(folder), entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) continue;
        if (is_left(dirfd(folder), entry->d_name, descriptor)) unlinkat(dirfd(folder), entry->d_name, 0);
        close(descriptor);
    }
    if (folder) closedir(folder);
    text_free(&stem);
    free(path);
}
