/* One error: what went wrong, where, and the exit status it becomes. */
#pragma once

#include <stdbool.h>

/* The program's exit statuses. */
typedef enum Status {
    STATUS_DONE = 0,
    STATUS_FAILURE = 1,      /* failure while running */
    STATUS_USAGE = 2,        /* wrong command line */
    STATUS_SCENE = 3,        /* scene or shader */
    STATUS_NO_GL = 4,        /* no OpenGL context */
    STATUS_OUTPUT = 5,       /* output not written */
    STATUS_COMPARISON = 6,   /* `compare` past its bound */
    STATUS_INTERRUPTED = 130 /* interrupted, picture saved */
} Status;

typedef struct Error {
    Status status;
    char text[4096]; /* one line first, starting with its place where it has one: "scenes/a.glsl:3: ..." */
} Error;

#define MUST_CHECK __attribute__((warn_unused_result))

/* Fills `error` and returns false, so that a failing function ends with `return error_set(...)`. */
bool error_set(Error *error, Status status, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Puts "prefix" in front of the text, keeping the status; returns false. */
bool error_prefix(Error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));
