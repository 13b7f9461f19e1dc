/* The annotations that make a uniform a parameter. */
#pragma once

#include "scene/annotation_line.h"

MUST_CHECK bool parameters_read_slider(Line *line, Error *error);
MUST_CHECK bool parameters_read_checkbox(Line *line, Error *error);
MUST_CHECK bool parameters_read_color(Line *line, Error *error);
