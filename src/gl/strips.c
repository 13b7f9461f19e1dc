#include "gl/strips.h"

#include "base/clock.h"

#include <math.h>

/* Returns the number of rows that have about `pixels` pixels. It is at least one, and a power of two, because
 * that suits the tiles of drivers. */
static int strip_rows(double pixels, int width, int rows_left) {
    int rows = 1;
    while (rows < rows_left && 2.0 * rows * width < pixels) rows *= 2;
    return rows < rows_left ? rows : rows_left;
}

bool strips_draw(const Program *program, const Rectangle *regions, int count, double *pixels_per_second,
                 bool (*stop)(void)) {
    double start = clock_seconds(), piece = 0.1 * *pixels_per_second, drawn = 0;
    for (int i = 0; i < count; i++) {
        const Rectangle *region = &regions[i];
        for (int row = 0; row < region->height;) {
            int rows = strip_rows(piece - drawn, region->width, region->height - row);
            program_draw(program, region->x, region->y + row, region->width, rows);
            row += rows;
            drawn += (double)rows * region->width;
            bool last = i == count - 1 && row == region->height;
            if (drawn < 0.5 * piece && !last) continue;
            program->gl->Finish();
            *pixels_per_second = drawn / fmax(clock_seconds() - start, 1e-6);
            if (!last && stop && stop()) return false;
            start = clock_seconds(), piece = 0.1 * *pixels_per_second, drawn = 0;
        }
    }
    return true;
}

/* Rows that are shaded together: llvmpipe shades blocks of two rows, and of four. */
static int whole_blocks(double wanted, int rows_left) {
    double rows = wanted < 4 ? 2 : 4 * floor(wanted / 4);
    return rows < rows_left ? (int)rows : rows_left;
}

void strips_draw_for(const Program *program, int width, int height, int *row, double *pixels_per_second,
                     double seconds, bool (*stop)(void)) {
    double end = clock_seconds() + seconds, left = seconds;
    do {
        double start = clock_seconds(), wanted = *pixels_per_second * fmin(left, seconds / 3) / width;
        int rows = whole_blocks(wanted, height - *row);
        program_draw(program, 0, *row, width, rows);
        program->gl->Finish();
        *pixels_per_second = (double)rows * width / fmax(clock_seconds() - start, 1e-6);
        *row += rows;
        left = end - clock_seconds();
    } while (*row < height && left > 0.1 * seconds && !(stop && stop()));
}
