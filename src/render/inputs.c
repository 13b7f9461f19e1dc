#include "render/inputs.h"

void inputs_parameters(const Scene *scene, Uniforms *uniforms) {
    for (int i = 0; i < scene->file->parameter_count; i++) {
        const Parameter *parameter = &scene->file->parameters[i];
        const double *value = scene->values.parameters[i];
        switch (parameter->type) {
        case PARAMETER_SLIDER:
            uniforms_float(uniforms, parameter->name, value[0]);
            break;
        case PARAMETER_CHECKBOX:
            uniforms_int(uniforms, parameter->name, value[0] > 0);
            break;
        case PARAMETER_COLOR:
            uniforms_vec3(uniforms, parameter->name, value);
            break;
        }
    }
}

void inputs_uniforms(const Frame *frame, Uniforms *uniforms) {
    double resolution[3] = {frame->camera.width, frame->camera.height, 1};
    uniforms_declared_in(uniforms, NULL);
    uniforms_vec3(uniforms, "iResolution", resolution);
    uniforms_float(uniforms, "iTime", frame->scene->values.time_s);
    uniforms_vec4(uniforms, "iMouse", frame->scene->values.mouse);
    inputs_parameters(frame->scene, uniforms);
}
