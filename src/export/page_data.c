#include "export/page_data.h"

#include "base/json.h"
#include "base/memory.h"
#include "export/page_variant.h"
#include "sky/observer.h"

#include <stdlib.h>
#include <string.h>

/* A variant that was made, and what it was made for. */
typedef struct Known {
    Text key;
    int number;
} Known;

/* Lines go to `out` at once, those of variants into texts of their own, so that each stands once. */
typedef struct Data {
    const PageParams *params;
    /* The methods of the first state, by name, for all of them. */
    RenderParams render;
    Plan plan;
    PageTexts texts;
    /* The lines of all variants, and for each variant the numbers of its lines. */
    PageList steps, variants;
    /* The variants by what they depend on. */
    Known *known;
    int known_count;
    FILE *out;
    Error *error;
} Data;

/* Variants have most of their lines in common. */
static int add_variant(Data *data, char *lines) {
    Text numbers = {0};
    for (char *line = lines; *line;) {
        char *end = strchr(line, '\n');
        *end = 0;
        text_print(&numbers, "%s%d", numbers.size ? " " : "", page_list_add(&data->steps, line));
        line = end + 1;
    }
    int number = page_list_add(&data->variants, text_string(&numbers));
    text_free(&numbers);
    return number;
}

/* What the script computes the sun, the light in mist and the spheres from: `forward` is the mist's `g` and
 * `spheres` how many there are, both a number or a slider's name. */
static void write_air(const Scene *scene, Text *lines) {
    const char *forward = scene->file->mist.words[MIST_FORWARD];
    text_print(lines, "{\"horizon\": %.17g, \"radius\": %.17g, \"forward\": \"%s\", \"spheres\": \"%s\"}\n",
               sky_horizon_sine(&scene->values.atmosphere), scene->values.sun.radius_deg,
               *forward ? forward : "0", scene_sphere_count(scene) >= 0 ? scene->file->spheres : "0");
}

/* What variants depend on, as bytes: not the sun's place, the camera and the sliders, which the script sets.
 */
static Text key_of(const Scene *scene) {
    const SceneValues *values = &scene->values;
    const bool flags[] = {values->sun_disk, scene_has_mist(scene), scene_has_air(scene)};
    Text key = {0};
    text_append(&key, &values->atmosphere, sizeof values->atmosphere);
    text_append(&key, &values->sun.radius_deg, sizeof values->sun.radius_deg);
    text_append(&key, &values->ignored_hints, sizeof values->ignored_hints);
    text_append(&key, flags, sizeof flags);
    return key;
}

static bool make_variant(Data *data, const Scene *scene, int *number) {
    RenderParams render = data->render;
    Plan plan;
    Text lines = {0};
    render.scene = scene;
    write_air(scene, &lines);
    bool ok = page_plan(&plan, &render, data->error) &&
              page_variant_write(&plan, &render, &data->texts, &lines, data->error);
    if (ok) *number = add_variant(data, lines.data);
    text_free(&lines);
    return ok;
}

/* The number of the variant that draws the scene. Presets ask for the same few. */
static bool find_variant(Data *data, const Scene *scene, int *number) {
    Text key = key_of(scene);
    for (int i = 0; i < data->known_count; i++) {
        Known *known = &data->known[i];
        if (known->key.size != key.size || memcmp(known->key.data, key.data, key.size) != 0) continue;
        text_free(&key);
        *number = known->number;
        return true;
    }
    if (!make_variant(data, scene, number)) {
        text_free(&key);
        return false;
    }
    data->known = memory_grow(data->known, (size_t)data->known_count + 1, sizeof *data->known);
    data->known[data->known_count++] = (Known){key, *number};
    return true;
}

/* The parameters that switch mist and air on and off, and with them programs. Returns how many there are. */
static int switches_of(const SceneFile *file, int switches[2]) {
    int count = 0;
    if (file->mist.line) switches[count++] = file->mist.parameter;
    if (file->air_line) switches[count++] = file->air_parameter;
    return count;
}

/* An error that begins with the scene's path, without the folder, which is of no use where the page is read.
 */
static const char *without_folder(const char *error, const char *path) {
    const char *slash = strrchr(path, '/');
    bool begins = slash && strncmp(error, path, strlen(path)) == 0;
    return begins ? error + (slash + 1 - path) : error;
}

/* Writes the variant for each setting of the switches: bit i of its place is switch i. A setting that a page
 * cannot draw is -1, and `why` says why; that of the state itself is an error. */
static bool write_variants(Data *data, const PageState *state, Json *json) {
    const SceneFile *file = state->scene.file;
    int switches[2], count = switches_of(file, switches);
    double numbers[4];
    Text names = {0}, why = {0};
    for (int setting = 0; setting < 1 << count; setting++) {
        Scene scene = state->scene;
        bool own = true;
        int number = -1;
        for (int i = 0; i < count; i++) {
            double *value = &scene.values.parameters[switches[i]][0], wanted = setting >> i & 1;
            own &= (*value > 0) == (wanted > 0);
            *value = wanted;
        }
        if (!find_variant(data, &scene, &number)) {
            if (own) return false;
            text_free(&why);
            text_print(&why, "%s", without_folder(data->error->text, file->path));
            number = -1;
        }
        numbers[setting] = number;
    }
    for (int i = 0; i < count; i++)
        text_print(&names, "%s%s", i ? " " : "", file->parameters[switches[i]].name);
    json_text(json, "switches", text_string(&names));
    json_numbers(json, "variants", numbers, 1 << count);
    if (why.size) json_text(json, "why", text_string(&why));
    text_free(&names);
    text_free(&why);
    return true;
}

static bool write_state(Data *data, const PageState *state) {
    const SceneValues *values = &state->scene.values;
    const SceneFile *file = state->scene.file;
    double sun[2] = {values->sun.elevation_deg, values->sun.azimuth_deg};
    Json json = json_begin();
    json_text(&json, "state", state->name);
    if (!write_variants(data, state, &json)) {
        text_free(&json.line);
        return false;
    }
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
    text_print(&methods, " --sky %s --light %s --sequence %s --sun-disk=%s", render->sky, render->light,
               render->sequence, render->sun_disk);
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
    for (int i = 0; i < data->steps.count; i++) fprintf(data->out, "%s\n", data->steps.items[i]);
    for (int i = 0; i < data->variants.count; i++) {
        Json json = json_begin();
        json_text(&json, "variant", data->variants.items[i]);
        json_end(&json, data->out);
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
    /* The sun moves, so that the sky's table has the precision for all its positions, and its size follows.
     */
    if (method_is_auto(data.render.sky) && !data.render.scene->file->sky[0])
        data.render.sky = "table:gauss:8";
    /* Presets have the methods of the first state, so that their pictures differ by what they set alone. */
    if (!page_plan(&data.plan, &data.render, error)) return false;
    if (!data.render.sky) data.render.sky = data.plan.sky.text;
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
    for (int i = 0; i < data.known_count; i++) text_free(&data.known[i].key);
    free(data.known);
    page_list_free(&data.steps);
    page_list_free(&data.variants);
    return ok;
}
