/* The annotation of mist, and what is checked of it when the whole file is read. */
#pragma once

#include "scene/annotation_line.h"

MUST_CHECK bool mist_read(Line *line, Error *error);

/* Whether each word is a number in its range, or a slider that stays in it. */
MUST_CHECK bool mist_check(const SceneFile *file, Error *error);
