/* The annotations that make a uniform a parameter. */
#pragma once

#include "scene/annotation_line.h"

MUST_CHECK bool parameters_read_slider(Line *line, Error *error);
MUST_CHECK bool parameters_read_checkbox(Line *line, Error *error);
MUST_CHECK bool parameters_read_color(Line *line, Error *error);

/* Adds a checkbox that is on and that no uniform of the scene stands for. Returns its number; -1 where the
 * name is taken. */
int parameters_add_switch(SceneFile *file, const char *name, const char *label, Error *error);

/* The slider of that name; NULL if there is none. */
const Parameter *parameters_find_slider(const SceneFile *file, const char *name);
