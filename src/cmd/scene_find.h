/* Finds the scene that a word of the command line means: a file, or an installed scene's name. */
#pragma once

#include "base/error.h"

/* An existing file of this name is taken first. Otherwise a word such as "crater", without a slash and
 * without
 * ".glsl", names a file of the folder `scenes` beside the GLSL library. The caller frees `path`. STATUS_SCENE
 * says where was looked, and which scene has a name like it. */
MUST_CHECK bool scene_find(const char *word, const char *library, char **path, Error *error);
