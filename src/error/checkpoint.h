/* A checkpoint is a file that holds the state of a picture, so that a render that was interrupted goes on as
 * if nothing had been in between.
 *
 * It begins with lines of text: CHECKPOINT_MAGIC, what is known of the picture, an empty line, the lines of
 * the picture's identity (render/identity.h), and another empty line. Then come 8 bytes with the size of the
 * state, 8 bytes with the checksum of all that is before and after these 8, and the state (base/archive.h).
 */
#pragma once

#include "error/adaptive.h"
#include "render/aov.h"

#define CHECKPOINT_MAGIC "magichour checkpoint 1\n"

/* The most bytes of a checkpoint: those of the largest picture. */
#define CHECKPOINT_MOST ((size_t)16 << 30)

/* What is saved and loaded. */
typedef struct Checkpoint {
    Renderer *renderer;
    Adaptive *adaptive;
    Aov *aov;
    /* Seconds of rendering so far. */
    double seconds;
    /* Lines that say what the picture is, and who draws it. */
    const char *identity, *driver;
    /* Further lines about the picture, for people; NULL when loading. */
    const char *about;
} Checkpoint;

/* Replaces the file, at once or not at all. The file that was there is kept as PATH.old. Fails with
 * STATUS_OUTPUT. */
MUST_CHECK bool checkpoint_write(const char *path, Checkpoint *checkpoint, Error *error);

/* Loads the state into a picture that was just begun. A file that is no checkpoint, that is damaged, or that
 * is of another picture is STATUS_FAILURE, and nothing is loaded. Sets `other_driver` to the one that drew
 * the picture so far if that is another one, to be freed, or else NULL. */
MUST_CHECK bool checkpoint_read(const char *path, Checkpoint *checkpoint, char **other_driver, Error *error);

/* Appends the lines about the picture and of its identity, out of a file's bytes. Fails if it is no whole
 * checkpoint. */
MUST_CHECK bool checkpoint_lines(const char *path, const Text *file, Text *lines, Error *error);

/* Whether a file's bytes begin as those of a checkpoint do, of whatever version. */
bool checkpoint_is_one(const Text *file);
