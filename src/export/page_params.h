/* What a page is made from. */
#pragma once

#include "render/plan.h"

/* The scene with the settings that the page begins with, or with those of a preset. */
typedef struct PageState {
    /* "" for the first. */
    const char *name;
    Scene scene;
} PageState;

typedef struct PageParams {
    /* The first is the one that the page begins with. They have the same file. */
    const PageState *states;
    int count;
    /* As for a render of the first state: what is NULL is chosen here. */
    RenderParams render;
    /* The command line that renders the first state, with the options that were given for all states. The
     * page adds the preset, the sun and what is changed. */
    const char *command;
} PageParams;
