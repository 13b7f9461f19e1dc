/* What the keys do, and the table that the help is made from. */
#pragma once

#include "view/state.h"

/* A line of the help, such as "right drag" and "move the sun". */
typedef struct KeysHelp {
    const char *keys, *what;
} KeysHelp;

/* Returns a line of the help, or NULL past the end. */
const KeysHelp *keys_help(int index);

/* Does what a key does at once, and again while it is held. `width` is the picture's. */
void keys_pressed(ViewState *state, int key, bool shift, int width);

/* Does what a key does once. */
void keys_pressed_once(ViewState *state, int key, int width);

/* A key that ends or corrects what is typed into the prompt for the sun's place. */
void keys_prompt(ViewState *state, int key);

/* A character: of the prompt if it is open, and else a key that has no place of its own on all keyboards. */
void keys_text(ViewState *state, unsigned codepoint);
