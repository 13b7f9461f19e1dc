/* The file in which the window remembers the panel's place, and that the first hint was seen. */
#pragma once

#include <stdbool.h>

/* Returns $XDG_STATE_HOME/magichour/window.ini, or the same below ~/.local/state; or NULL if there is
 * neither. The caller frees it. */
char *remember_path(void);

/* Says whether the file is there. */
bool remember_exists(const char *path);

/* Writes the file, and makes the folders that it needs. If that is not possible, nothing is remembered. */
void remember_write(const char *path, const char *text);
