/* Draws a pass in pieces that take about a tenth of a second each. The pass can be stopped between pieces,
 * and no driver believes that a draw hangs. */
#pragma once

#include "base/rectangle.h"
#include "gl/program.h"

/* Draws `program`, which must be in use, on these regions of the bound framebuffer, and waits until it is
 * done. `pixels_per_second` is a guess, and is set to the measured speed. `stop` may be NULL; it is called
 * between pieces. Returns false if `stop` returned true before the end. */
bool strips_draw(const Program *program, const Rectangle *regions, int count, double *pixels_per_second,
                 bool (*stop)(void));

/* Draws rows of [0, width) x [0, height) for about `seconds`, from *row on and at least two rows. Sets *row
 * to the next row. A strip takes about a third of the time, because some rows of a picture take several times
 * as long as others. */
void strips_draw_for(const Program *program, int width, int height, int *row, double *pixels_per_second,
                     double seconds, bool (*stop)(void));
