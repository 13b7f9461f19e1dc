/* What the tests share: GLSL evaluated texel by texel, the program run as a user runs it, a folder to work
 * in. */
#pragma once

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "gl/context.h"
#include "image/format.h"
#include "source/glsl_source.h"

/* Ends a test that needs OpenGL where there is none: skips it with the reason, or fails it if the environment
 * says REQUIRE_GL=1. */
void support_no_gl(const char *reason);

/* Opens the first backend that there is, or ends the test with support_no_gl(). */
void support_open(Context *context);

/* How many samples a statistical test takes: these, or a part of them if the environment says
 * FEWER_SAMPLES=N. Its bounds must come from the measured noise. */
uint64_t support_samples(uint64_t samples);

/* The side of the blocks of pixels that together have the samples that one pixel has without FEWER_SAMPLES:
 * 1, or more. */
int support_block(void);

/* Adds a row to a table of tests/README.md, where the environment says MAGICHOUR_TABLE=FILE (tests/table.sh).
 * `kind` tells the tables apart. */
void support_table(const char *kind, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Runs a group of tests as cmocka does, and prints the time of each. */
int support_run_tests(const char *name, const struct CMUnitTest *tests, size_t count, CMFixtureFunction setup,
                      CMFixtureFunction teardown);
#undef cmocka_run_group_tests_name
#define cmocka_run_group_tests_name(name, tests, setup, teardown)                                            \
    support_run_tests(name, tests, sizeof(tests) / sizeof *(tests), setup, teardown)

/* Compiles `glsl`, which defines `vec4 evaluate(vec2 texel)` (texel in whole numbers, row 0 first) and may
 * fetch from `uniform sampler2D inputs` (the same size; NULL for none), and reads the results: 4 * width *
 * height floats. */
void support_evaluate(const Context *context, const char *glsl, const float *inputs, int width, int height,
                      float *results);

/* A new folder for this test program, removed with its files by support_clean (group setup and teardown). */
int support_folder(void **state);
int support_clean(void **state);

/* folder/name; stays good to the program's end. */
const char *support_path(const char *name);

/* Writes a text file into the folder and gives its path. */
const char *support_write(const char *name, const char *text);

/* Appends the metadata of that name of a picture file; false where there is none. */
bool support_attribute(const char *path, const char *name, Text *value);

/* The texts of the GLSL library, which no test changes in place. */
SourceStore *support_sources(void);

/* glsl_source_create() with texts that are read anew, and the GLSL library in this folder. */
bool support_flatten(GlslSource *source, const char *library, const char *entry, const GlslSlot *slots,
                     Error *error);

/* Runs `magichour ARGUMENTS` through the shell; `environment` in front ("LP_NUM_THREADS=1") may be "". Gives
 * the exit status; what it printed is in support_out and support_err until the next run. */
int support_run(const char *environment, const char *format, ...) __attribute__((format(printf, 2, 3)));
extern char support_out[262144], support_err[65536];

/* A number of the last line of --progress json in support_err; -1 where it has none of that name. */
double support_figure(const char *name);

/* The exit status and the start of standard error, together in one readable failure. */
void support_expect(int status, const char *error_part, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
