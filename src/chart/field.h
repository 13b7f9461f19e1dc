/* Scenes for measuring cost against the number of shapes. A scene is a field of equal spheres on a plane. The
 * spheres cover the same part of the plane, and of the picture, however many they are. */
#pragma once

#include "base/text.h"

enum { FIELD_MOST_CALLS = 100 };

/* Writes a scene with one call of hit_sphere() for each sphere, for up to FIELD_MOST_CALLS spheres. */
void field_of_calls(int count, Text *out);

/* Writes a scene with one call of hit_spheres() for all spheres (`//@ spheres`). */
void field_of_set(int count, Text *out);
