/* Saves a state as bytes, and loads it again. One function walks through a state in both directions: each
 * call of archive_bytes() saves what is there, or overwrites it with what was saved. The bytes are this
 * machine's own: floats and whole numbers of its size and order. */
#pragma once

#include "base/text.h"

#include <stdint.h>

typedef struct Archive {
    /* What is saved goes here; NULL when loading. */
    Text *out;
    /* What is left to load. */
    const char *at, *end;
    /* Whether there was less to load than was asked for. What lacked is 0 then. */
    bool torn;
} Archive;

static inline bool archive_loads(const Archive *archive) {
    return !archive->out;
}

void archive_bytes(Archive *archive, void *data, size_t size);

/* The same for what is true or false, whatever the loaded byte is. */
void archive_bool(Archive *archive, bool *value);

/* The same for a variable. It must not hold pointers. */
#define ARCHIVE(archive, variable) archive_bytes(archive, &(variable), sizeof(variable))

/* A checksum of many bytes. It finds what time and accidents do to a file, and not what is made to fool it.
 */
uint64_t checksum(const void *data, size_t size);

/* The 64-bit FNV-1a of the bytes, which continues `hash`; that of nothing is 0. */
uint64_t hash_bytes(uint64_t hash, const void *data, size_t size);
