/* A picture's programs as JSON lines, for who wants to draw it elsewhere. */
#pragma once

#include "render/passes.h"

#include <stdio.h>

/* Prints, for each pass in the order in which they are drawn,
 *
 *   {"pass": NAME, "order": K, "entry": FILE, "fills": TABLE or "", "width": W, "height": H, "text": GLSL}
 *   {"pass": NAME, "uniform": NAME, "type": "vec3", "declared_in": FILE or "", "values": [...]}
 *   {"pass": NAME, "sampler": NAME, "reads": TABLE, "output": K}
 *
 * The width and the height are texels of a table, or the picture's. Of a pass that is drawn again and again,
 * what changes from one time to the next (the film's textures, the number of samples) is not listed. */
MUST_CHECK bool pass_json_print(const Plan *plan, const RenderParams *params, FILE *file, Error *error);
