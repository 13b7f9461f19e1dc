/* The `//@` lines of a scene file. */
#pragma once

#include "scene/scene.h"

/* Fills the scene from the annotations in the file at scene->path. STATUS_SCENE with "path:line: ...". */
MUST_CHECK bool annotation_read(Scene *scene, Error *error);
