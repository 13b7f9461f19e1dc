/* An error: what went wrong, where, and the exit status of the program. */
#pragma once

#include <stdbool.h>

/* The program's exit statuses. */
typedef enum Status {
    STATUS_DONE = 0,
    /* Failure while running. */
    STATUS_FAILURE = 1,
    /* Wrong command line. */
    STATUS_USAGE = 2,
    /* Fault in a scene or a shader. */
    STATUS_SCENE = 3,
    /* No OpenGL context. */
    STATUS_NO_GL = 4,
    /* The output could not be written. */
    STATUS_OUTPUT = 5,
    /* The comparison of `compare` is past its bound. */
    STATUS_COMPARISON = 6,
    /* The picture is written, but the error that `--error` asked for is not promised. */
    STATUS_UNPROMISED = 7,
    /* Interrupted by the user; the picture is saved. */
    STATUS_INTERRUPTED = 130
} Status;

typedef struct Error {
    Status status;
    /* The first line says what is wrong. It begins with the place, if there is one: "scenes/a.glsl:3: ...".
     */
    char text[4096];
} Error;

#define MUST_CHECK __attribute__((warn_unused_result))

/* Fills `error` and returns false, so that a failing function ends with `return error_set(...)`. */
bool error_set(Error *error, Status status, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Puts a prefix in front of the text, keeps the status, and returns false. */
bool error_prefix(Error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));
