/* The #line directives that the flattener writes. */
#pragma once

#include <stdbool.h>

/* Reads "#line LINE FILE" at `at`; false, with both as they were, for anything else. It takes no longer on a
 * long text, as sscanf() would. */
bool glsl_line_read(const char *at, int *line, int *file);
