#define _XOPEN_SOURCE 600
#include "terminal.h"

#include "support.h"

#include "base/clock.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

void terminal_open(Terminal *terminal, int columns) {
    struct winsize size = {.ws_row = 24, .ws_col = (unsigned short)columns};
    terminal->master = posix_openpt(O_RDWR | O_NOCTTY);
    const char *name =
        terminal->master >= 0 && grantpt(terminal->master) == 0 && unlockpt(terminal->master) == 0
            ? ptsname(terminal->master)
            : NULL;
    if (!name) {
        print_message("no terminal can be made here\n");
        skip();
        return;
    }
    snprintf(terminal->name, sizeof terminal->name, "%s", name);
    /* While the terminal is open here, what was written stays when its writer ends. */
    terminal->kept = open(name, O_RDWR | O_NOCTTY);
    assert_true(terminal->kept >= 0);
    ioctl(terminal->kept, TIOCSWINSZ, &size);
    fcntl(terminal->master, F_SETFL, O_NONBLOCK);
}

size_t terminal_read(const Terminal *terminal, char *text, size_t size) {
    size_t length = 0;
    ssize_t got;
    while (length + 1 < size && (got = read(terminal->master, text + length, size - 1 - length)) > 0)
        length += (size_t)got;
    text[length] = 0;
    return length;
}

void terminal_type(const Terminal *terminal, const char *keys) {
    assert_int_equal(write(terminal->master, keys, strlen(keys)), strlen(keys));
}

bool terminal_await(const Terminal *terminal, const char *words, double seconds, char *text, size_t size) {
    size_t length = 0;
    for (double end = clock_seconds() + seconds; clock_seconds() < end;) {
        length += terminal_read(terminal, text + length, size - length);
        if (strstr(text, words)) return true;
        nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
    }
    return false;
}

void terminal_close(Terminal *terminal) {
    close(terminal->kept);
    close(terminal->master);
}
