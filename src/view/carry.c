#include "view/carry.h"

#include <math.h>
#include <string.h>

/* One setting of several numbers, which are kept together. */
static void carry(double *next, const double *file, const double *current, int count) {
    size_t size = (size_t)count * sizeof *next;
    if (memcmp(file, current, size) != 0) memcpy(next, current, size);
}

static void carry_camera(Scene *next, const Scene *file, const Scene *current) {
    bool moved = memcmp(file->eye, current->eye, sizeof file->eye) != 0 ||
                 memcmp(file->target, current->target, sizeof file->target) != 0 ||
                 file->fov_deg < current->fov_deg || file->fov_deg > current->fov_deg;
    if (!moved) return;
    memcpy(next->eye, current->eye, sizeof next->eye);
    memcpy(next->target, current->target, sizeof next->target);
    next->fov_deg = current->fov_deg;
}

static void carry_atmosphere(Atmosphere *next, const Atmosphere *file, const Atmosphere *current) {
    for (int i = 0; atmosphere_field(i); i++) {
        const AtmosphereField *field = atmosphere_field(i);
        double *target = (double *)(void *)((char *)next + field->offset);
        carry(target, atmosphere_value(file, field), atmosphere_value(current, field), field->count);
    }
}

static const Parameter *find(const Scene *scene, const char *name, ParameterType type) {
    for (int i = 0; i < scene->parameter_count; i++) {
        const Parameter *parameter = &scene->parameters[i];
        if (parameter->type == type && strcmp(parameter->name, name) == 0) return parameter;
    }
    return NULL;
}

static void carry_parameter(Parameter *next, const Scene *file, const Scene *current) {
    const Parameter *before = find(file, next->name, next->type),
                    *now = find(current, next->name, next->type);
    if (!before || !now) return;
    carry(next->value, before->value, now->value, 3);
    if (next->type != PARAMETER_SLIDER) return;
    next->value[0] = fmin(fmax(next->value[0], next->min), next->max);
}

void carry_over(Scene *next, const Scene *file, const Scene *current) {
    carry_camera(next, file, current);
    carry(&next->sun_elevation_deg, &file->sun_elevation_deg, &current->sun_elevation_deg, 1);
    carry(&next->sun_azimuth_deg, &file->sun_azimuth_deg, &current->sun_azimuth_deg, 1);
    carry(&next->sun_radius_deg, &file->sun_radius_deg, &current->sun_radius_deg, 1);
    carry(&next->exposure_ev, &file->exposure_ev, &current->exposure_ev, 1);
    if (file->sun_disk != current->sun_disk) next->sun_disk = current->sun_disk;
    carry_atmosphere(&next->atmosphere, &file->atmosphere, &current->atmosphere);
    for (int i = 0; i < next->parameter_count; i++) carry_parameter(&next->parameters[i], file, current);
}
