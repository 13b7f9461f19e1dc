#include "render/inputs.h"

static const char *const inputs[][2] = {
    {"vec3", "iResolution"}, {"float", "iTime"}, {"int", "iFrame"}, {"vec4", "iMouse"}};
enum { INPUTS = sizeof inputs / sizeof *inputs };

unsigned inputs_wanted(const GlslSource *scene) {
    unsigned wanted = 0;
    for (int i = 0; i < INPUTS; i++) {
        bool owed = glsl_source_mentions(scene, inputs[i][1]) &&
                    !glsl_source_declares(scene, inputs[i][0], inputs[i][1]);
        if (owed) wanted |= 1U << i;
    }
    return wanted;
}

void inputs_declare(unsigned wanted, Text *declarations) {
    for (int i = 0; i < INPUTS; i++) {
        if (wanted & 1U << i) text_print(declarations, "uniform %s %s;\n", inputs[i][0], inputs[i][1]);
    }
}

void inputs_set(const Program *program, const Scene *scene, int width, int height) {
    double resolution[3] = {width, height, 1};
    program_set_vec3(program, "iResolution", resolution);
    program_set_float(program, "iTime", scene->values.time_s);
    program_set_vec4(program, "iMouse", scene->values.mouse);
}
