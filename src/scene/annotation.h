/* The `//@` lines of a scene file. */
#pragma once

#include "scene/scene_file.h"

/* Fills `file` from the annotations in the file at file->path. STATUS_SCENE with "path:line: ...". */
MUST_CHECK bool annotation_read(SceneFile *file, Error *error);
