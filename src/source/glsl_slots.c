#include "source/glsl_slots.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

/* A slot that is there already is filled anew. */
static GlslSlot *slot_of(SlotList *list, const char *name) {
    for (int i = 0; i < list->count; i++) {
        GlslSlot *slot = &list->slots[i];
        if (strcmp(slot->name, name) != 0) continue;
        free((char *)slot->path);
        free((char *)slot->text);
        slot->path = slot->text = NULL;
        return slot;
    }
    list->slots = memory_grow(list->slots, (size_t)list->count + 2, sizeof *list->slots);
    list->slots[list->count] = (GlslSlot){.name = memory_string(name)};
    list->slots[list->count + 1] = (GlslSlot){0};
    return &list->slots[list->count++];
}

void slot_file(SlotList *list, const char *name, const char *path) {
    slot_of(list, name)->path = memory_string(path);
}

void slot_text(SlotList *list, const char *name, const char *text) {
    slot_of(list, name)->text = memory_string(text);
}

void slot_list_free(SlotList *list) {
    for (int i = 0; i < list->count; i++) {
        free((char *)list->slots[i].name);
        free((char *)list->slots[i].path);
        free((char *)list->slots[i].text);
    }
    free(list->slots);
    *list = (SlotList){0};
}
