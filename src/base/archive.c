#include "base/archive.h"

#include <string.h>

void archive_bytes(Archive *archive, void *data, size_t size) {
    if (archive->out) {
        text_append(archive->out, data, size);
        return;
    }
    size_t left = (size_t)(archive->end - archive->at);
    if (size > left) {
        archive->torn = true;
        archive->at = archive->end;
        memset(data, 0, size);
        return;
    }
    if (size) memcpy(data, archive->at, size);
    archive->at += size;
}

void archive_bool(Archive *archive, bool *value) {
    unsigned char byte = *value;
    archive_bytes(archive, &byte, 1);
    *value = byte != 0;
}

uint64_t hash_bytes(uint64_t hash, const void *data, size_t size) {
    const unsigned char *bytes = data;
    if (!hash) hash = 0xcbf29ce484222325U;
    for (size_t i = 0; i < size; i++) hash = (hash ^ bytes[i]) * 0x100000001b3U;
    return hash;
}

uint64_t checksum(const void *data, size_t size) {
    const char *bytes = data;
    uint64_t sum = size;
    for (size_t i = 0; i < size; i += 8) {
        uint64_t word = 0;
        memcpy(&word, bytes + i, size - i < 8 ? size - i : 8);
        sum = (sum ^ word) * 0x9e3779b97f4a7c15U;
        sum ^= sum >> 32;
    }
    return sum;
}
