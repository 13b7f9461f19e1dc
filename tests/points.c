#include "points.h"

#include "random.h"
#include "support.h"

#include <math.h>
#include <stdio.h>

void points_make(float *inputs, int items, double reach, double step, double decades) {
    for (int i = 0; i < items; i++) {
        float *p = inputs + 8 * i, *q = p + 4;
        double most = step * pow(10, -decades * random_unit());
        for (int c = 0; c < 3; c++) {
            p[c] = (float)(reach * (2 * random_unit() - 1));
            q[c] = p[c] + (float)(most * (2 * random_unit() - 1));
        }
    }
}

void points_evaluate(const Context *context, const char *declarations, const char *body, const float *inputs,
                     int width, int height, float *results) {
    static char glsl[8192];
    snprintf(glsl, sizeof glsl,
             "uniform sampler2D inputs;\n%s\n"
             "vec4 evaluate(vec2 t) {\n"
             "    ivec2 at = ivec2(int(t.x) / 2 * 2, int(t.y));\n"
             "    vec3 p = texelFetch(inputs, at, 0).xyz;\n"
             "    vec3 q = texelFetch(inputs, at + ivec2(1, 0), 0).xyz;\n"
             "    vec4 c = vec4(0.0);\n    %s\n    return c;\n}\n",
             declarations, body);
    support_evaluate(context, glsl, inputs, width, height, results);
}
