/* What a flattened text's slots are filled with: a list that grows by name. */
#pragma once

#include "source/glsl_source.h"

/* A zeroed list is empty. It owns its words. */
typedef struct SlotList {
    /* Ends with an empty one, as glsl_source_create() takes them; NULL while the list is empty. */
    GlslSlot *slots;
    int count;
} SlotList;

/* Fills <name> with a file of the library, or of the user's where the name is "scene" or "common". */
void slot_file(SlotList *list, const char *name, const char *path);

/* Fills <name> with GLSL that the host wrote. */
void slot_text(SlotList *list, const char *name, const char *text);

void slot_list_free(SlotList *list);
