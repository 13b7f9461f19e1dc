/* Words for the light that a picture leaves to chance (see gl/film.h). */
#pragma once

#include "gl/film.h"
#include "render/plan.h"

/* Whether the light left to chance deserves a warning: a thousandth of the picture's light or more. */
bool chance_matters(const FilmChance *chance);

/* Writes which materials throw the light that is left to chance, such as "glass and rough metal", for use in
 * a sentence. */
void chance_throwers(const FilmChance *chance, const SceneFacts *facts, char *text, size_t size);
