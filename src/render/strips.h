/* A pass drawn in strips of rows, each about a tenth of a second's work, so that it can be stopped between
 * them and no driver takes a draw for hung. */
#pragma once

#include "gl/program.h"

/* Draws `program`, which is in use, on the bound framebuffer's rows from 0 to height, and waits for it.
 * `rows_per_second` is a guess, and becomes what was measured. `stop` (may be NULL) is asked between strips;
 * whether the last row was reached. */
bool strips_draw(const Program *program, int width, int height, double *rows_per_second, bool (*stop)(void));
