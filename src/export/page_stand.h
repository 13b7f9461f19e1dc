/* How a page comes by the tables that the host computes for a render. */
#pragma once

#include "gl/resource.h"

typedef struct PageStand {
    const ResourceKind *kind;
    /* The shader that draws the table in a page; NULL where `maker` makes it, a function of the page's
     * script.
     */
    const char *entry, *maker;
    /* Its size: as it is here, or what the script finds under that name. */
    int width, height;
    const char *sized;
} PageStand;

/* NULL where a page has the table as a render has it, or not at all. */
const PageStand *page_stand_of(const ResourceKind *kind);
