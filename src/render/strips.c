#include "render/strips.h"

#include "base/clock.h"

#include <math.h>

static int strip_rows(double rows_per_second, int rows_left) {
    int rows = 1;
    while (rows < rows_left && rows * 2 < rows_per_second * 0.1) rows *= 2;
    return rows < rows_left ? rows : rows_left;
}

bool strips_draw(const Program *program, int width, int height, double *rows_per_second, bool (*stop)(void)) {
    for (int row = 0; row < height;) {
        int rows = strip_rows(*rows_per_second, height - row);
        double start = clock_seconds();
        program_draw(program, 0, row, width, rows);
        program->gl->Finish();
        *rows_per_second = rows / fmax(clock_seconds() - start, 1e-6);
        row += rows;
        if (row < height && stop && stop()) return false;
    }
    return true;
}
