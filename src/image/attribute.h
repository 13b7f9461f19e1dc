/* A picture's metadata: lines of a name and a text, in the order in which they were added. */
#pragma once

/* Names are an EXR attribute's, such as "magichour.seed". The list owns both strings. */
typedef struct Attribute {
    char *name;
    char *value;
} Attribute;

/* A zeroed list is empty. */
typedef struct AttributeList {
    Attribute *items;
    int count;
} AttributeList;

void attribute_add(AttributeList *list, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void attribute_list_free(AttributeList *list);
