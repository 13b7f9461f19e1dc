/* Scenes made to be counted: a field of equal spheres on a plane, as many as asked for, which cover the same
 * part of it and of the picture whatever their number. */
#pragma once

#include "base/text.h"

enum { FIELD_MOST_CALLS = 100 };

/* One call of hit_sphere() for each: up to FIELD_MOST_CALLS. */
void field_of_calls(int count, Text *out);

/* One call of hit_spheres() for all (`//@ spheres`). */
void field_of_set(int count, Text *out);
