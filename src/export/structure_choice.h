/* WebGL refuses `?:` between structures, which GLSL 3.30 and other compilers of GLSL ES take. */
#pragma once

#include "source/glsl_source.h"

/* STATUS_SCENE with the place names the first one of a flattened text. */
MUST_CHECK bool structure_choice_check(const GlslSource *source, Error *error);
