/* Keeps what the user has set in the window when the scene's file is read again. */
#pragma once

#include "scene/scene.h"

/* `file` is the scene as the file was before, `next` as the file is now, and `current` as the user has set
 * it. What differs between `current` and `file` is copied into `next`. Everything else keeps the file's new
 * value. Parameters are found by their names, and are kept within their new ranges. */
void carry_over(Scene *next, const Scene *file, const Scene *current);
