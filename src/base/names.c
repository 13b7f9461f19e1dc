#include "base/names.h"

#include "base/memory.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* FNV-1a, 64 bits. */
static uint64_t hash_of(const char *name, size_t size) {
    uint64_t hash = 0xcbf29ce484222325;
    for (size_t i = 0; i < size; i++) hash = (hash ^ (unsigned char)name[i]) * 0x100000001b3;
    return hash ^ hash >> 32;
}

/* Where the name stands among the slots, or would stand. */
static size_t slot_of(const Names *names, const char *name, size_t size) {
    size_t slot = hash_of(name, size) % names->slot_count;
    for (; names->slots[slot]; slot = (slot + 1) % names->slot_count) {
        const char *other = names->list[names->slots[slot] - 1];
        if (strncmp(other, name, size) == 0 && !other[size]) break;
    }
    return slot;
}

/* At least half of the slots stay empty. */
static void grow(Names *names) {
    if (2 * ((size_t)names->count + 1) <= names->slot_count) return;
    free(names->slots);
    names->slot_count = names->slot_count ? 2 * names->slot_count : 64;
    names->slots = memory_get(names->slot_count, sizeof *names->slots);
    names->list = memory_grow(names->list, names->slot_count / 2, sizeof *names->list);
    for (int i = 0; i < names->count; i++)
        names->slots[slot_of(names, names->list[i], strlen(names->list[i]))] = i + 1;
}

int names_find(const Names *names, const char *name, size_t size) {
    return names->slot_count ? names->slots[slot_of(names, name, size)] - 1 : -1;
}

int names_add(Names *names, const char *name, size_t size) {
    grow(names);
    size_t slot = slot_of(names, name, size);
    if (!names->slots[slot]) {
        names->list[names->count++] = memory_string_part(name, size);
        names->slots[slot] = names->count;
    }
    return names->slots[slot] - 1;
}

void names_free(Names *names) {
    for (int i = 0; i < names->count; i++) free(names->list[i]);
    free(names->list);
    free(names->slots);
    *names = (Names){0};
}
