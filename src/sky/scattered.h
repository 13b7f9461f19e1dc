/* The light of the open sky that a scene's mist scatters, by the direction from the eye: a table that paths
 * take as a control variate (glsl/light/path.glsl). */
#pragma once

#include "sky/sky_patches.h"

extern const ResourceKind sky_scattered;

/* Whether the picture takes it: it has mist, and looks its sky up in a table or has one that is the same in
 * all directions. */
bool sky_is_scattered(const MethodChoice *sky, const Scene *scene);
