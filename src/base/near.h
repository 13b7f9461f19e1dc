/* "Did you mean": the known word that is most like a mistyped one.
 *
 *     Near near = near_to(word, strlen(word));
 *     for (int i = 0; names[i]; i++) near_try(&near, names[i]);
 *     if (near.name) ... did you mean near.name?
 */
#pragma once

#include <stddef.h>

typedef struct Near {
    const char *word;
    size_t length;
    /* The nearest name that was tried, or NULL if none is like the word. It belongs to the caller. */
    const char *name;
    /* The number of letters that must be inserted, removed, changed or swapped with their neighbour to make
     * the name of the word. */
    size_t distance;
} Near;

/* No name was tried yet. The word has `length` bytes and stays the caller's. */
Near near_to(const char *word, size_t length);

/* Takes the name if it is nearer than those before. At most one letter in three may be wrong; the dashes that
 * an option begins with are no letters. */
void near_try(Near *near, const char *name);
