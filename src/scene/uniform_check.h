/* The uniforms of a scene that nothing sets. They would be 0, in silence. */
#pragma once

#include "scene/scene_file.h"
#include "source/glsl_source.h"

/* Checks that each uniform that the scene's own files declare is an annotated parameter, one of the host's,
 * or has a value in its declaration. The error names the declaration's place and what to write there. */
MUST_CHECK bool uniform_check(const SceneFile *file, const GlslSource *source, Error *error);
