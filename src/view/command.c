#include "view/command.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Prints the shortest digits that read back as the same number. */
static void print_number(Text *text, const char *before, double value) {
    char shortest[40];
    for (int digits = 6; digits <= 17; digits++) {
        snprintf(shortest, sizeof shortest, "%.*g", digits, value);
        double back = strtod(shortest, NULL);
        if (memcmp(&back, &value, sizeof back) == 0) break;
    }
    text_print(text, "%s%s", before, shortest);
}

static void print_setting(Text *text, const char *group, const char *name, const double *values, int count) {
    text_print(text, " --set %s%s=", group, name);
    for (int i = 0; i < count; i++) print_number(text, i ? "," : "", values[i]);
}

static bool differ(const double *a, const double *b, int count) {
    return memcmp(a, b, (size_t)count * sizeof *a) != 0;
}

/* Wavelengths and the like come first, because setting them recomputes the Rayleigh coefficients, which
 * follow. */
static void print_atmosphere(Text *text, const Atmosphere *atmosphere, const Atmosphere *file) {
    static const char *const first[] = {"wavelengths_nm", "refractive_index", "molecules_per_m3"};
    bool anew = false;
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; atmosphere_field(i); i++) {
            const AtmosphereField *field = atmosphere_field(i);
            const double *values = atmosphere_value(atmosphere, field);
            bool early = false;
            for (int k = 0; k < 3; k++) early |= strcmp(first[k], field->name) == 0;
            bool wanted = differ(values, atmosphere_value(file, field), field->count) ||
                          (anew && strcmp(field->name, "rayleigh_scatter_per_m") == 0);
            if (early != (pass == 0) || !wanted) continue;
            if (field->words[0].word) {
                text_print(text, " --set atmosphere.%s=", field->name);
                atmosphere_print_value(atmosphere, field, text);
            } else {
                print_setting(text, "atmosphere.", field->name, values, field->count);
            }
            anew |= early;
        }
    }
}

static void print_parameters(Text *text, const Scene *scene) {
    const SceneFile *file = scene->file;
    for (int i = 0; i < file->parameter_count; i++) {
        const double *now = scene->values.parameters[i];
        int count = file->parameters[i].type == PARAMETER_COLOR ? 3 : 1;
        if (differ(now, file->values.parameters[i], count))
            print_setting(text, "", file->parameters[i].name, now, count);
    }
}

static void print_scene(Text *text, const char *command, const SceneFile *scene, const char *glsl_dir) {
    text_print(text, "magichour %s ", command);
    /* A path that begins with a hyphen would be an option. */
    if (*scene->path == '-') text_print(text, "./");
    text_print_quoted(text, scene->path);
    if (!glsl_dir) return;
    text_print(text, " --glsl-dir ");
    text_print_quoted(text, glsl_dir);
}

static void print_sun(Text *text, const Sun *sun) {
    print_number(text, " --sun ", sun->elevation_deg);
    print_number(text, ",", sun->azimuth_deg);
}

/* All settings that differ from the file's but the sun's place. */
static void print_differences(Text *text, const Scene *scene) {
    const SceneValues *now = &scene->values, *file = &scene->file->values;
    if (differ(&now->sun.radius_deg, &file->sun.radius_deg, 1))
        print_setting(text, "sun.", "radius", &now->sun.radius_deg, 1);
    if (differ(now->camera.eye, file->camera.eye, 3))
        print_setting(text, "camera.", "eye", now->camera.eye, 3);
    if (differ(now->camera.target, file->camera.target, 3))
        print_setting(text, "camera.", "target", now->camera.target, 3);
    if (differ(&now->camera.fov_deg, &file->camera.fov_deg, 1))
        print_setting(text, "camera.", "fov", &now->camera.fov_deg, 1);
    if (differ(&now->exposure_ev, &file->exposure_ev, 1))
        print_number(text, " --exposure ", now->exposure_ev);
    if (differ(&now->time_s, &file->time_s, 1)) print_setting(text, "", "time", &now->time_s, 1);
    if (differ(now->mouse, file->mouse, 4)) print_setting(text, "", "mouse", now->mouse, 4);
    print_parameters(text, scene);
    print_atmosphere(text, &now->atmosphere, &file->atmosphere);
}

void view_command(const CommandParams *params, Text *command) {
    const SceneValues *now = &params->scene->values;
    const Renderer *renderer = params->renderer;
    print_scene(command, "render", params->scene->file, params->glsl_dir);
    text_print(command, " -o picture.exr --size %dx%d --spp %" PRIu64, renderer->camera.width,
               renderer->camera.height, renderer->film.samples);
    text_print(command, " --sky %s --light %s --sequence %s --sun-disk=%s", renderer->plan.sky.text,
               renderer->plan.light.text, renderer->plan.sequence.text, renderer->plan.sun.text);
    if (now->atmosphere.orders > 1) text_print(command, " --further %s", renderer->plan.further.text);
    if (renderer->seed) text_print(command, " --seed %u", renderer->seed);
    if (params->max_hits) text_print(command, " --depth %d", params->max_hits);
    print_sun(command, &now->sun);
    print_differences(command, params->scene);
}

static void print_method(Text *text, const char *option, const char *name) {
    if (*name) text_print(text, "%s%s", option, name);
}

void view_link(const LinkParams *params, Text *command) {
    const Scene *scene = params->scene;
    const SceneFile *file = scene->file;
    const MethodNames *methods = params->methods;
    const Sun *now = &scene->values.sun, *own = &file->values.sun;
    print_scene(command, "view", file, params->glsl_dir);
    if (params->width != file->width || params->height != file->height)
        text_print(command, " --size %dx%d", params->width, params->height);
    print_method(command, " --sky ", methods->sky);
    print_method(command, " --further ", methods->further);
    print_method(command, " --light ", methods->light);
    print_method(command, " --sequence ", methods->sequence);
    print_method(command, " --sun-disk=", methods->sun_disk);
    if (params->seed) text_print(command, " --seed %u", params->seed);
    if (params->max_hits) text_print(command, " --depth %d", params->max_hits);
    if (differ(&now->elevation_deg, &own->elevation_deg, 1) ||
        differ(&now->azimuth_deg, &own->azimuth_deg, 1))
        print_sun(command, now);
    print_differences(command, scene);
}
