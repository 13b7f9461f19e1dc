/* What a picture leaves to chance, in words. */
#pragma once

#include "gl/film.h"
#include "render/plan.h"

/* Whether it is worth a warning: from a thousandth of the picture's light. */
bool chance_matters(const FilmChance *chance);

/* What throws the light that is found by chance, such as "glass and rough metal", for a sentence. */
void chance_throwers(const FilmChance *chance, const SceneNeeds *needs, char *text, size_t size);
