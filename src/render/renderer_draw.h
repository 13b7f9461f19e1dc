/* For renderer.c: what drawing a group of samples begins with. */
#pragma once

#include "render/renderer.h"

/* Makes the tracing program the one in use, for a group of so many samples that the film takes in next. */
void renderer_begin_group(Renderer *renderer, unsigned group);
