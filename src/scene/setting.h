/* Settings by name, as --set, presets and annotations make them; the ranges of all values stand here. */
#pragma once

#include "scene/scene_file.h"

/* Sets "sun.elevation", "camera.fov", "exposure", "atmosphere.mie_g" or one of the file's parameters.
 * STATUS_USAGE names what is known. */
MUST_CHECK bool setting_apply(const SceneFile *file, SceneValues *values, const char *name, const char *value,
                              Error *error);

/* Applies the settings of one of the file's presets. STATUS_USAGE names what is known. */
MUST_CHECK bool setting_choose_preset(const SceneFile *file, SceneValues *values, const char *name,
                                      Error *error);

/* The names of the settings that every scene has, without the atmosphere's; NULL past the end. */
const char *setting_common(int index);

/* Whether every scene has a setting of that name. */
bool setting_is_common(const char *name);

/* Pictures' limits, as a sentence for errors and the check itself (STATUS_USAGE). */
MUST_CHECK bool scene_check_size(double width, double height, Error *error);
