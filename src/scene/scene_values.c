#include "scene/scene_values.h"

#include <assert.h>
#include <string.h>

/* All members before sun_disk are doubles without padding between them, so that their bytes can be compared
 * together. */
static_assert(offsetof(SceneValues, sun_disk) == sizeof(Viewpoint) + sizeof(Sun) + sizeof(SunClock) +
                                                     sizeof(Atmosphere) + sizeof(double[1 + 1 + 4]) +
                                                     sizeof(double[MOST_PARAMETERS][3]),
              "padding");
static_assert(sizeof(Viewpoint) == sizeof(double[7]) && sizeof(Sun) == sizeof(double[9]) &&
                  sizeof(SunClock) == sizeof(double[6]),
              "padding");

bool scene_values_same(const SceneValues *a, const SceneValues *b) {
    return memcmp(a, b, offsetof(SceneValues, sun_disk)) == 0 && a->sun_disk == b->sun_disk &&
           a->ignored_hints == b->ignored_hints;
}
