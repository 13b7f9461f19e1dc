/* A list of names in which each is found at once, however many there are. */
#pragma once

#include <stddef.h>

/* A zeroed list is empty. */
typedef struct Names {
    /* In the order in which they came; owned. */
    char **list;
    int count;
    /* The numbers of the names by their hashes, from 1; 0 where there is none. */
    int *slots;
    size_t slot_count;
} Names;

/* The number of the name of `size` bytes, from 0; -1 where it is not in the list. */
int names_find(const Names *names, const char *name, size_t size);

/* Adds the name where it is not in the list yet, and gives its number. */
int names_add(Names *names, const char *name, size_t size);
void names_free(Names *names);
