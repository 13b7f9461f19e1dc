/* The files of tests/data/toys and what their comments expect of them (tests/test_toy.c). */
#pragma once

#include "support.h"

/* The path of each file in turn, and then NULL once. */
const char *toys_next(void);

/* The words behind the `number`-th comment of this kind, from 0: false where there is none. */
bool toys_line(const char *path, const char *kind, int number, char *words, size_t size);

/* Fails the test if a pixel of the picture is not what the file expects, by more than a level. A picture that
 * is not `shown` has the levels as its values. Returns how many pixels were judged. */
int toys_check(const char *path, const Image *image);

/* Writes a file that llvmpipe compiles for some seconds, and that no run has compiled before. All its pixels
 * have a green of 0.6. */
const char *toys_write_slow(const char *name);

/* The same as a scene. */
const char *toys_write_slow_scene(const char *name);
