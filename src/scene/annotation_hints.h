/* The annotations of hints and of many spheres. */
#pragma once

#include "scene/annotation_line.h"

/* Whether words[0] is the key of a kind of hint. */
bool hints_know(const Line *line, HintKind *kind);

MUST_CHECK bool hints_read(Line *line, HintKind kind, Error *error);

MUST_CHECK bool hints_read_spheres(Line *line, Error *error);

/* Whether the annotation `spheres` names a file. */
bool hints_name_file(const SceneFile *file);

/* The words of hints may be sliders that are declared below them: checked when all are read. */
MUST_CHECK bool hints_check(const SceneFile *file, Error *error);
