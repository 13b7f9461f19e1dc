/* A hand that drops a file on a window, by the XDND protocol. */
#pragma once

#include <stdbool.h>

/* Drops a file at a place of the screen on the window of that number, on display `:display`. Returns whether
 * the window took it. The path has no character that a URI would escape. */
bool drop_file(int display, unsigned long target, int x, int y, const char *path);
