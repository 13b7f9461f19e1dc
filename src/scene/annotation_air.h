/* The annotation of the atmosphere's air between the surfaces: `//@ air on`. */
#pragma once

#include "scene/annotation_line.h"

MUST_CHECK bool air_read(Line *line, Error *error);
