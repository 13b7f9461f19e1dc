#include "export/page_data.h"

#include "base/json.h"
#include "base/memory.h"
#include "export/page_variant.h"
#include "sky/observer.h"

#include <stdlib.h>
#include <string.h>

/* Lines go to `out` at once, those of variants into texts of their own, so that each stands once. */
typedef struct Data {
    const PageParams *params;
    /* The methods of the first state, by name, for all of them. */
    RenderParams render;
    Plan plan;
    PageTexts texts;
    Text *variants;
    int variant_count;
    FILE *out;
    Error *error;
} Data;

/* The number of the variant that draws the scene. */
static bool find_variant(Data *data, const Scene *scene, int *number) {
    RenderParams render = data->render;
    Plan plan;
    Text lines = {0};
    render.scene = scene;
    text_print(&lines, "{\"horizon\": %.9g}\n", sky_horizon_sine(&scene->values.atmosphere));
    text_print(&lines, "{\"radius\": %.9g}\n", scene->values.sun.radius_deg);
    if (!page_plan(&plan, &render, data->error) ||
        !page_variant_write(&plan, &render, &data->texts, &lines, data->error)) {
        text_free(&lines);
        return false;
    }
    for (*number = 0; *number < data->variant_count; ++*number) {
        if (strcmp(text_string(&data->variants[*number]), text_string(&lines)) != 0) continue;
        text_free(&lines);
        return true;
    }
    data->variants = memory_grow(data->variants, (size_t)++data->variant_count, sizeof *data->variants);
    data->variants[*number] = lines;
    return true;
}

/* The parameter that switches mist or air on and off, and with them programs; -1 where there is none. */
static int switch_of(const SceneFile *file) {
    return file->mist.line ? file->mist.parameter : file->air_line ? file->air_parameter : -1;
}

static bool write_state(Data *data, const PageState *state) {
    const SceneValues *values = &state->scene.values;
    const SceneFile *file = state->scene.file;
    int variant, flipped = -1, toggle = switch_of(file);
    if (!find_variant(data, &state->scene, &variant)) return false;
    if (toggle >= 0) {
        Scene other = state->scene;
        other.values.parameters[toggle][0] = !(other.values.parameters[toggle][0] > 0);
        if (!find_variant(data, &other, &flipped)) return false;
    }
    double sun[2] = {values->sun.elevation_deg, values->sun.azimuth_deg};
    Json json = json_begin();
    json_text(&json, "state", state->name);
    json_count(&json, "variant", (uint64_t)variant);
    if (flipped >= 0) json_text(&json, "switch", file->parameters[toggle].name);
    if (flipped >= 0) json_count(&json, "flipped", (uint64_t)flipped);
    json_numbers(&json, "sun", sun, 2);
    json_numbers(&json, "eye", values->camera.eye, 3);
    json_numbers(&json, "target", values->camera.target, 3);
    json_number(&json, "fov", values->camera.fov_deg);
    json_number(&json, "exposure", values->exposure_ev);
    json_number(&json, "time", values->time_s);
    json_end(&json, data->out);
    for (int i = 0; i < file->parameter_count; i++) {
        json = json_begin();
        json_text(&json, "value", file->parameters[i].name);
        json_numbers(&json, "values", values->parameters[i],
                     file->parameters[i].type == PARAMETER_COLOR ? 3 : 1);
        json_end(&json, data->out);
    }
    return true;
}

static void write_parameter(const Data *data, const Parameter *parameter) {
    static const char *const types[] = {"slider", "checkbox", "color"};
    Json json = json_begin();
    json_text(&json, "parameter", parameter->name);
    json_text(&json, "type", types[parameter->type]);
    json_text(&json, "label", parameter->label);
    json_text(&json, "unit", parameter->unit);
    json_number(&json, "min", parameter->min);
    json_number(&json, "max", parameter->max);
    json_end(&json, data->out);
}

static void write_head(const Data *data) {
    const RenderParams *render = &data->render;
    const Plan *plan = &data->plan;
    Text methods = {0};
    text_print(&methods, " --sky %s --light %s --sequence %s --sun-disk=%s", plan->sky.text, plan->light.text,
               plan->sequence.text, plan->sun.text);
    if (plan->has_orders) text_print(&methods, " --further %s", plan->further.text);
    if (render->seed) text_print(&methods, " --seed %u", render->seed);
    if (render->max_hits) text_print(&methods, " --depth %d", render->max_hits);
    Json json = json_begin();
    json_text(&json, "title", render->scene->file->title);
    json_count(&json, "width", (uint64_t)plan_width(render));
    json_count(&json, "height", (uint64_t)plan_height(render));
    json_count(&json, "seed", render->seed);
    json_text(&json, "command", data->params->command);
    json_text(&json, "methods", text_string(&methods));
    json_end(&json, data->out);
    text_free(&methods);
}

/* The program that shows the film; `way` is the file that converts it. */
static bool write_shown(Data *data, const char *name, const char *way) {
    const GlslSlot slots[] = {{"shown", way, NULL}, {NULL, NULL, NULL}};
    GlslSource source = {0};
    if (!glsl_source_create(&source, data->render.scene->file->sources, "pass/display.glsl", slots,
                            data->error))
        return false;
    Json json = json_begin();
    json_text(&json, "shows", name);
    json_count(&json, "draws", (uint64_t)page_texts_add(&data->texts, &source));
    json_end(&json, data->out);
    glsl_source_destroy(&source);
    return true;
}

static bool write_all(Data *data) {
    const SceneFile *file = data->render.scene->file;
    write_head(data);
    for (int i = 0; i < file->parameter_count; i++) write_parameter(data, &file->parameters[i]);
    for (int i = 0; i < data->params->count; i++)
        if (!write_state(data, &data->params->states[i])) return false;
    for (int i = 0; i < data->variant_count; i++) {
        Json json = json_begin();
        json_count(&json, "variant", (uint64_t)i);
        json_end(&json, data->out);
        fputs(text_string(&data->variants[i]), data->out);
    }
    if (!write_shown(data, "same", "pass/shown_picture.glsl") ||
        !write_shown(data, "enlarged", "pass/shown_enlarged.glsl"))
        return false;
    page_texts_write(&data->texts, data->out);
    return true;
}

bool page_data(const PageParams *params, Text *lines, Error *error) {
    Data data = {.params = params, .render = params->render, .error = error};
    char *bytes = NULL;
    size_t size = 0;
    data.render.scene = &params->states[0].scene;
    /* Presets have the methods of the first state, so that their pictures differ by what they set alone. */
    if (!page_plan(&data.plan, &data.render, error)) return false;
    data.render.sky = data.plan.sky.text;
    data.render.light = data.plan.light.text;
    data.render.sequence = data.plan.sequence.text;
    data.render.sun_disk = data.plan.sun.text;
    if (data.plan.has_orders) data.render.further = data.plan.further.text;
    data.out = open_memstream(&bytes, &size);
    bool ok = write_all(&data);
    fclose(data.out);
    if (ok) text_append(lines, bytes, size);
    free(bytes);
    page_texts_free(&data.texts);
    for (int i = 0; i < data.variant_count; i++) text_free(&data.variants[i]);
    free(data.variants);
    return ok;
}
