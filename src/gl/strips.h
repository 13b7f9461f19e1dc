/* A pass drawn in pieces, each about a tenth of a second's work, so that it can be stopped between them and
 * no driver takes a draw for hung. */
#pragma once

#include "gl/camera.h"

/* Draws `program`, which is in use, on these regions of the bound framebuffer, and waits for it.
 * `pixels_per_second` is a guess, and becomes what was measured. `stop` (may be NULL) is asked between
 * pieces; whether the end was reached. */
bool strips_draw(const Program *program, const Rectangle *regions, int count, double *pixels_per_second,
                 bool (*stop)(void));

/* Draws the rows of [0, width) x [0, height) from *row on for about `seconds`, at least one; *row becomes the
 * next. In strips of a third of the time, as some rows of a picture take several times as long as others. */
void strips_draw_for(const Program *program, int width, int height, int *row, double *pixels_per_second,
                     double seconds, bool (*stop)(void));
