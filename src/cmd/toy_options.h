/* The options of files that paint their pictures by themselves (render/toy.h). */
#pragma once

#include "cmd/options.h"
#include "scene/scene_file.h"

/* Refuses the first option that such a file has no use for, by STATUS_USAGE. */
MUST_CHECK bool toy_options_check(const Options *options, const SceneFile *file, Error *error);
