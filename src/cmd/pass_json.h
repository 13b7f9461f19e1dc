/* Writes a picture's programs as JSON lines, for other programs that draw the picture. */
#pragma once

#include "render/passes.h"

#include <stdio.h>

/* Prints these lines for each pass, in the order in which passes are drawn:
 *
 *   {"pass": NAME, "order": K, "entry": FILE, "fills": TABLE or "", "width": W, "height": H, "text": GLSL}
 *   {"pass": NAME, "uniform": NAME, "type": "vec3", "declared_in": FILE or "", "values": [...]}
 *   {"pass": NAME, "sampler": NAME, "reads": TABLE, "output": K}
 *
 * The size is that of the table, in texels, or of the picture. For a pass that is drawn repeatedly, what
 * changes from one time to the next (the film's textures and the number of samples) is not listed. */
MUST_CHECK bool pass_json_print(const Plan *plan, const RenderParams *params, FILE *file, Error *error);
