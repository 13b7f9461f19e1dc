/* A plot as files. */
#pragma once

#include "chart/plot.h"

/* Writes PATH.svg and PATH.png, and replaces files that exist. A plot is 800 units wide; the PNG has two
 * pixels a unit. Fails with STATUS_OUTPUT. */
MUST_CHECK bool plot_write(const Plot *plot, const char *path, Error *error);
