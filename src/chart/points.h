/* Points of time and error that other programs reached, to be drawn beside the curves of a chart. They come
 * from a CSV:
 *
 *     program,seconds,percent
 *     Mitsuba 3.9.1 path,0.92,45
 *
 * The points of a program are in the order of time, one behind the other. */
#pragma once

#include "base/error.h"
#include "chart/pareto.h"

enum { MOST_PROGRAMS = 4, MOST_PROGRAM_POINTS = 32 };

typedef struct ProgramPoints {
    char name[40];
    ParetoPoint points[MOST_PROGRAM_POINTS];
    int count;
} ProgramPoints;

typedef struct Points {
    ProgramPoints programs[MOST_PROGRAMS];
    int count;
} Points;

/* Errors are STATUS_USAGE and name the file and the line. */
MUST_CHECK bool points_read(Points *points, const char *path, Error *error);
