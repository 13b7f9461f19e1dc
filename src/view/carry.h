/* What the user has set in the window, kept when the scene's file is read anew. */
#pragma once

#include "scene/scene.h"

/* Whatever differs in `current` from what the file said before (`file`) goes into `next`, the file as it says
 * now; what was left alone takes the file's new value. Parameters are found by their names and kept within
 * their new ranges. */
void carry_over(Scene *next, const Scene *file, const Scene *current);
