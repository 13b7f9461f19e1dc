/* What lies between a scene's surfaces, in words for who has never met the numbers. */
#pragma once

#include "scene/scene.h"

/* Appends a line of the scene's mist and a line of its air, with the values that they have, and whether they
 * are switched off; nothing where the scene has neither. */
void mist_words(const Scene *scene, Text *text);
