#include "view/carry.h"

#include "scene/sun_clock.h"

#include <math.h>
#include <string.h>

/* Copies one setting of `count` numbers, which are kept together. */
static void carry(double *next, const double *file, const double *current, int count) {
    size_t size = (size_t)count * sizeof *next;
    if (memcmp(file, current, size) != 0) memcpy(next, current, size);
}

static void carry_camera(Viewpoint *next, const Viewpoint *file, const Viewpoint *current) {
    if (memcmp(file, current, sizeof *file) != 0) *next = *current;
}

static void carry_sun(Sun *next, const Sun *file, const Sun *current) {
    Sun sun = *next;
    carry(&sun.elevation_deg, &file->elevation_deg, &current->elevation_deg, 1);
    carry(&sun.azimuth_deg, &file->azimuth_deg, &current->azimuth_deg, 1);
    carry(&sun.radius_deg, &file->radius_deg, &current->radius_deg, 1);
    *next = sun_at(sun.elevation_deg, sun.azimuth_deg, sun.radius_deg);
}

/* A clock that runs says where the sun stands. */
static void carry_clock(SceneValues *next, const SunClock *file, const SunClock *current) {
    if (memcmp(file, current, sizeof *file) != 0) next->clock = *current;
    if (sun_clock_runs(&next->clock)) sun_clock_set_utc(next, next->clock.utc_s);
}

static void carry_atmosphere(Atmosphere *next, const Atmosphere *file, const Atmosphere *current) {
    for (int i = 0; atmosphere_field(i); i++) {
        const AtmosphereField *field = atmosphere_field(i);
        double *target = (double *)(void *)((char *)next + field->offset);
        carry(target, atmosphere_value(file, field), atmosphere_value(current, field), field->count);
    }
}

/* The parameter's number, or -1. */
static int find(const SceneFile *file, const Parameter *wanted) {
    for (int i = 0; i < file->parameter_count; i++) {
        const Parameter *parameter = &file->parameters[i];
        if (parameter->type == wanted->type && strcmp(parameter->name, wanted->name) == 0) return i;
    }
    return -1;
}

static void carry_parameter(Scene *next, int number, const Scene *file, const Scene *current) {
    const Parameter *parameter = &next->file->parameters[number];
    double *value = next->values.parameters[number];
    int before = find(file->file, parameter), now = find(current->file, parameter);
    if (before < 0 || now < 0) return;
    carry(value, file->values.parameters[before], current->values.parameters[now], 3);
    if (parameter->type == PARAMETER_SLIDER) value[0] = fmin(fmax(value[0], parameter->min), parameter->max);
}

void carry_over(Scene *next, const Scene *file, const Scene *current) {
    SceneValues *to = &next->values;
    const SceneValues *before = &file->values, *now = &current->values;
    carry_camera(&to->camera, &before->camera, &now->camera);
    carry_sun(&to->sun, &before->sun, &now->sun);
    carry_clock(to, &before->clock, &now->clock);
    carry(&to->exposure_ev, &before->exposure_ev, &now->exposure_ev, 1);
    if (before->sun_disk != now->sun_disk) to->sun_disk = now->sun_disk;
    carry_atmosphere(&to->atmosphere, &before->atmosphere, &now->atmosphere);
    for (int i = 0; i < next->file->parameter_count; i++) carry_parameter(next, i, file, current);
}
