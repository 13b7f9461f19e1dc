#include "render/describe.h"

#include <math.h>
#include <stdio.h>

void describe_value(AttributeList *list, const char *group, const char *name, const double *value,
                    int count) {
    char full[96];
    snprintf(full, sizeof full, "magichour.%s.%s", group, name);
    if (count == 3) {
        attribute_add(list, full, "%.9g,%.9g,%.9g", value[0], value[1], value[2]);
    } else {
        attribute_add(list, full, "%.9g", value[0]);
    }
}

void describe_atmosphere(const Atmosphere *atmosphere, AttributeList *list) {
    for (int i = 0; atmosphere_field(i); i++) {
        const AtmosphereField *field = atmosphere_field(i);
        char full[96];
        Text value = {0};
        snprintf(full, sizeof full, "magichour.atmosphere.%s", field->name);
        atmosphere_print_value(atmosphere, field, &value);
        attribute_add(list, full, "%s", text_string(&value));
        text_free(&value);
    }
}

void describe_picture(AttributeList *list, const Scene *scene, const Renderer *renderer,
                      const Context *context) {
    attribute_add(list, "magichour.scene", "%s", scene->file->path);
    attribute_add(list, "magichour.sun", "elevation %.9g azimuth %.9g", scene->values.sun.elevation_deg,
                  scene->values.sun.azimuth_deg);
    attribute_add(list, "magichour.sun_disk", "%s, radius %.9g degrees", renderer->plan.sun.text,
                  scene->values.sun.radius_deg);
    attribute_add(list, "magichour.exposure", "%.9g", scene->values.exposure_ev);
    attribute_add(list, "magichour.sky", "%s", renderer->plan.sky.text);
    if (scene->values.atmosphere.orders > 1)
        attribute_add(list, "magichour.further", "%s", renderer->plan.further.text);
    if (!isnan(renderer->sky_bias_percent))
        attribute_add(list, "magichour.sky_bias_percent", "%.3g", renderer->sky_bias_percent);
    attribute_add(list, "magichour.light", "%s", renderer->plan.light.text);
    attribute_add(list, "magichour.sequence", "%s", renderer->plan.sequence.text);
    attribute_add(list, "magichour.seed", "%u", renderer->seed);
    if (scene->values.time_s > 0) attribute_add(list, "magichour.time", "%.9g", scene->values.time_s);
    const double *mouse = scene->values.mouse;
    if (mouse[0] != 0 || mouse[1] != 0 || mouse[2] != 0 || mouse[3] != 0)
        attribute_add(list, "magichour.mouse", "%.9g,%.9g,%.9g,%.9g", mouse[0], mouse[1], mouse[2], mouse[3]);
    attribute_add(list, "magichour.backend", "%s%s%s", context->backend ? context->backend->name : "window",
                  context->backend ? ", " : "", context->detail);
    attribute_add(list, "magichour.gl_renderer", "%s", context->renderer);
    attribute_add(list, "magichour.gl_version", "%s", context->version);
    for (int i = 0; i < scene->file->parameter_count; i++) {
        const Parameter *parameter = &scene->file->parameters[i];
        describe_value(list, "set", parameter->name, scene->values.parameters[i],
                       parameter->type == PARAMETER_COLOR ? 3 : 1);
    }
    describe_atmosphere(&scene->values.atmosphere, list);
}

void describe_chance(const ChanceShares *chance, AttributeList *list) {
    if (!(chance->paths > 0)) return;
    attribute_add(list, "magichour.chance_paths_percent", "%.3g", 100 * chance->paths);
    attribute_add(list, "magichour.chance_pixels_percent", "%.3g", 100 * chance->pixels);
    attribute_add(list, "magichour.chance_light_percent", "%.3g", 100 * chance->light);
}

void describe_search(const FilmSearch *search, AttributeList *list) {
    if (!(search->rays > 0)) return;
    attribute_add(list, "magichour.searches",
                  "%.0f rays, %.2f steps each, %.0f in a field that is no distance, %.0f cut", search->rays,
                  search->steps / search->rays, search->broken, search->cut);
}
