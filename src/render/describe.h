/* A picture's metadata, from which it can be made again. Names are "magichour.NAME" or
 * "magichour.GROUP.NAME". */
#pragma once

#include "image/attribute.h"
#include "render/chance.h"
#include "render/renderer.h"

/* Adds a value of one number or three. */
void describe_value(AttributeList *list, const char *group, const char *name, const double *value, int count);
void describe_atmosphere(const Atmosphere *atmosphere, AttributeList *list);

/* Adds the scene, sun, exposure, methods, seed, OpenGL, parameters and atmosphere, and iTime and iMouse where
 * they are not 0. */
void describe_picture(AttributeList *list, const Scene *scene, const Renderer *renderer,
                      const Context *context);

/* Adds how much light is left to chance, and how rays searched, if there is any of it. */
void describe_chance(const ChanceShares *chance, AttributeList *list);
void describe_search(const FilmSearch *search, AttributeList *list);
