/* The hints that a scene defines in GLSL. */
#pragma once

#include "scene/scene_file.h"

/* Finds them in the scene, flattened alone, and notes their numbers in file->hints. STATUS_SCENE with the
 * place where a constant or a function lacks the other, or an annotation says the same once more. */
MUST_CHECK bool hint_glsl_find(SceneFile *file, const GlslSource *source, Error *error);
