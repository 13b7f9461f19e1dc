/* A program written for Shadertoy: a file that defines mainImage() and no scene. Each frame sees the one
 * before as iChannel0. */
#pragma once

#include "gl/target.h"

#include <stdint.h>

typedef struct Toy {
    Program program; /* empty where there is no such file */
    Target target;
    int frame;                /* that is being drawn; its predecessor is the front */
    int row;                  /* where it is */
    double pixels_per_second; /* measured */
    double time_s, delta_s;   /* of that frame */
    double mouse[4];
} Toy;

/* Whether the file is one. False too where it cannot be read, which is for others to say. */
bool toy_is(const char *library, const char *path);

/* Replaces the program and keeps the history. A `toy` that is empty becomes one. STATUS_SCENE with
 * "file:line: ..." leaves it as it was. */
MUST_CHECK bool toy_compile(Toy *toy, const Context *context, const char *library, const char *path,
                            Error *error);
void toy_destroy(Toy *toy);

/* Makes it this large, which begins anew where it was not. */
MUST_CHECK bool toy_resize(Toy *toy, const Context *context, int width, int height, Error *error);
void toy_restart(Toy *toy);

/* Draws for about `seconds`, or until `stop` says yes; a frame may take several calls and keeps the time and
 * the mouse that it began with. */
MUST_CHECK bool toy_draw(Toy *toy, double seconds, double time_s, const double mouse[4], bool (*stop)(void),
                         Error *error);

/* The last whole frame, row 0 at its bottom. */
GLuint toy_texture(const Toy *toy);
