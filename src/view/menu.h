/* The scenes that can be opened by a click: those beside the open one, and those that are installed. */
#pragma once

#include "scene/scene_list.h"
#include "view/state.h"

typedef struct SceneMenu {
    /* Of the folder of the open scene, and of the installed ones; the second is empty if both are the same.
     */
    SceneList beside, installed;
} SceneMenu;

/* Reads the lists if `state` wishes it. */
void menu_update(SceneMenu *menu, ViewState *state, const char *library);
void menu_free(SceneMenu *menu);
