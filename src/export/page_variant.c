#include "export/page_variant.h"

#include "base/json.h"
#include "base/memory.h"
#include "export/es.h"
#include "export/page_frame.h"
#include "export/page_stand.h"
#include "render/drawn_mirrors.h"
#include "sky/sun.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_STEPS = 64 };

typedef struct Writer {
    const Plan *plan;
    const RenderParams *params;
    PageTexts *texts;
    Frame frame;
    PageScan scans[2];
    FILE *file;
    Error *error;
} Writer;

static bool is_needed(const Writer *writer, const ResourceKind *kind) {
    return kind != &drawn_mirrors && resource_is_needed(kind, picture_tables, &writer->frame);
}

static bool same_size(int entry, const PageFrame *a, const PageFrame *b) {
    return a->width[entry] == b->width[entry] && a->height[entry] == b->height[entry];
}

/* Whether previews have the same values as pictures at rest. */
static bool same_scans(const Writer *writer, int entry, PageSame *same) {
    const PageFrame *at_rest = writer->scans[0].frames, *coarse = writer->scans[1].frames;
    for (int i = 0; i < PAGE_FRAMES; i++)
        if (!same(entry, &at_rest[i], &coarse[i])) return false;
    return true;
}

/* The value as a program gets it. */
static double rounded(const Uniform *uniform, int i) {
    double value = uniform->type == UNIFORM_FLOATS ? uniform->many[i] : uniform->values[i];
    bool whole = uniform->type == UNIFORM_INT || uniform->type == UNIFORM_UINT;
    return whole ? value : (double)(float)value;
}

static void write_value(const Writer *writer, const Uniform *uniform, double from_deg, bool coarse) {
    static const int components[] = {1, 1, 1, 3, 4, 1};
    bool many = uniform->type == UNIFORM_FLOATS;
    Json json = json_begin();
    json_text(&json, "uniform", uniform->name);
    if (from_deg > -90) json_number(&json, "from", from_deg);
    if (coarse) json_flag(&json, "coarse", true);
    int count = many ? uniform->count : components[uniform->type];
    double *values = memory_get((size_t)count, sizeof *values);
    /* Rounded once, as the host rounds them: nine digits are enough for a float, and for it alone. */
    for (int i = 0; i < count; i++) values[i] = rounded(uniform, i);
    json_numbers(&json, "values", values, count);
    json_end(&json, writer->file);
    free(values);
}

/* Whether the uniform has been written with the same values, and not with others since. */
static bool is_written(const Writer *writer, int entry) {
    const Uniform *items = writer->scans[0].frames[0].uniforms.items;
    int before = entry - 1;
    while (before >= 0 && strcmp(items[before].name, items[entry].name) != 0) before--;
    if (before < 0) return false;
    for (int coarse = 0; coarse < 2; coarse++) {
        for (int i = 0; i < PAGE_FRAMES; i++) {
            const Uniforms *uniforms = &writer->scans[coarse].frames[i].uniforms;
            if (!page_same_values(&uniforms->items[before], &uniforms->items[entry])) return false;
        }
    }
    return true;
}

/* A uniform of a preview stands only where it differs from that of a picture at rest. */
static bool write_uniform(const Writer *writer, int entry) {
    double from[MOST_STEPS];
    const PageFrame *frames[MOST_STEPS];
    const Uniform *first = &writer->scans[0].frames[0].uniforms.items[entry];
    if (page_computes(first) || is_written(writer, entry)) return true;
    for (int coarse = 0; coarse < 2; coarse++) {
        int count =
            page_scan_steps(&writer->scans[coarse], entry, page_same_uniform, MOST_STEPS, from, frames);
        if (!count)
            return error_set(writer->error, STATUS_USAGE,
                             "%s changes with the sun in a way that a page does not compute", first->name);
        if (coarse && same_scans(writer, entry, page_same_uniform)) continue;
        for (int i = 0; i < count; i++)
            write_value(writer, &frames[i]->uniforms.items[entry], from[i], coarse != 0);
    }
    return true;
}

static bool write_uniforms(const Writer *writer, int from, int upto) {
    for (int i = from; i < upto; i++)
        if (!write_uniform(writer, i)) return false;
    return true;
}

static bool add_text(const Writer *writer, const char *entry, int *number) {
    const Pass pass = {.entry = entry};
    GlslSource source = {0};
    bool ok = pass_text(&pass, writer->plan, writer->params, &source, writer->error) &&
              es_mend(&source, writer->params->scene->file->sources->folder, writer->error);
    if (ok) *number = page_texts_add(writer->texts, &source);
    glsl_source_destroy(&source);
    return ok;
}

/* Sizes are lines of their own, before the table's. */
static void write_sizes(const Writer *writer, int place, const PageStand *stand) {
    double from[MOST_STEPS];
    const PageFrame *frames[MOST_STEPS];
    for (int coarse = 0; coarse < 2; coarse++) {
        int count =
            stand ? 1 : page_scan_steps(&writer->scans[coarse], place, same_size, MOST_STEPS, from, frames);
        if (coarse && (stand || same_scans(writer, place, same_size))) continue;
        for (int i = 0; i < count; i++) {
            double size[2] = {stand ? stand->width : frames[i]->width[place],
                              stand ? stand->height : frames[i]->height[place]};
            Json json = json_begin();
            json_text(&json, "uniform", "size");
            if (!stand && from[i] > -90) json_number(&json, "from", from[i]);
            if (coarse) json_flag(&json, "coarse", true);
            json_numbers(&json, "values", size, 2);
            json_end(&json, writer->file);
        }
    }
}

static int place_of(const ResourceKind *kind) {
    int place = 0;
    while (picture_tables[place] != kind) place++;
    return place;
}

/* Which textures its program reads under names that are not the textures' own: "rays_air=3.0", texture 0 of
 * table 3. */
static void write_reads(const ResourceKind *kind, Text *reads, Text *inputs) {
    for (int i = 0; i < RESOURCE_INPUTS; i++) {
        if (!kind->inputs[i]) continue;
        text_print(inputs, "%s%d", inputs->size ? " " : "", place_of(kind->inputs[i]));
        for (int t = 0; t < RESOURCE_TEXTURES; t++) {
            const char *sampler = kind->input_samplers[i][t];
            if (sampler)
                text_print(reads, "%s%s=%d.%d", reads->size ? " " : "", sampler, place_of(kind->inputs[i]),
                           t);
        }
    }
}

static bool write_table(const Writer *writer, int place) {
    const ResourceKind *kind = picture_tables[place];
    const PageStand *stand = page_stand_of(kind);
    const char *entry = stand ? stand->entry : kind->entry;
    int text = -1;
    if (entry && !add_text(writer, entry, &text)) return false;
    write_sizes(writer, place, stand);
    Text reads = {0}, inputs = {0}, samplers = {0};
    write_reads(kind, &reads, &inputs);
    for (int t = 0; t < RESOURCE_TEXTURES; t++)
        text_print(&samplers, "%s%s", t ? " " : "", kind->samplers[t] ? kind->samplers[t] : "");
    Json json = json_begin();
    json_text(&json, "table", kind->name);
    json_count(&json, "place", (uint64_t)place);
    if (text >= 0) json_count(&json, "draws", (uint64_t)text);
    if (stand && stand->maker) json_text(&json, "maker", stand->maker);
    if (stand && stand->sized) json_text(&json, "sized", stand->sized);
    json_text(&json, "samplers", text_string(&samplers));
    json_text(&json, "inputs", text_string(&inputs));
    json_text(&json, "reads", text_string(&reads));
    json_flag(&json, "linear", kind->filter == GL_LINEAR);
    json_end(&json, writer->file);
    text_free(&reads);
    text_free(&inputs);
    text_free(&samplers);
    return true;
}

static bool write_film(const Writer *writer) {
    int trace, image = -1;
    if (!add_text(writer, trace_pass.entry, &trace) ||
        (writer->plan->sun.method->draws_image && !add_text(writer, sun_image_pass.entry, &image)))
        return false;
    Json json = json_begin();
    json_text(&json, "table", "film");
    json_count(&json, "draws", (uint64_t)trace);
    if (image >= 0) json_count(&json, "image", (uint64_t)image);
    if (image >= 0)
        json_flag(&json, "mirrors", scene_hint_count(writer->params->scene, HINT_MIRROR_SPHERE) > 0);
    json_count(&json, "group", writer->plan->group_samples);
    json_end(&json, writer->file);
    return true;
}

static bool same_or_computed(int entry, const PageFrame *a, const PageFrame *b) {
    return page_computes(&a->uniforms.items[entry]) || page_same_uniform(entry, a, b);
}

/* A slider that the GLSL reads costs nothing. One that the host reads too, such as that of a mist's `g`,
 * would change a table's numbers, which the page has as they are. */
static bool check_sliders(const Writer *writer) {
    const char *slider, *name = page_scan_slider(&writer->scans[0], same_or_computed, &slider);
    if (!name) return true;
    return error_set(
        writer->error, STATUS_SCENE,
        "%s: the slider %s changes %s, which a page does not compute: write a number in its place, "
        "or --light and --sky that need no such table",
        writer->params->scene->file->path, slider, name);
}

static bool write_all(const Writer *writer) {
    const PageFrame *any = &writer->scans[0].frames[0];
    if (!check_sliders(writer)) return false;
    if (!write_uniforms(writer, 0, any->from[0])) return false;
    for (int i = 0; picture_tables[i]; i++) {
        if (!is_needed(writer, picture_tables[i])) continue;
        if (!write_uniforms(writer, any->from[i], any->upto[i]) || !write_table(writer, i)) return false;
    }
    return write_film(writer);
}

bool page_variant_write(const Plan *plan, const RenderParams *params, PageTexts *texts, Text *lines,
                        Error *error) {
    Camera camera = camera_of(params->scene, plan_width(params), plan_height(params));
    char *data = NULL;
    size_t size = 0;
    Writer writer = {plan,
                     params,
                     texts,
                     frame_of(plan, params, &camera),
                     {page_scan(plan, params, false), page_scan(plan, params, true)},
                     open_memstream(&data, &size),
                     error};
    bool ok = write_all(&writer);
    fclose(writer.file);
    if (ok) text_append(lines, data, size);
    free(data);
    page_scan_free(&writer.scans[0]);
    page_scan_free(&writer.scans[1]);
    return ok;
}

/* The sun of a page rises and sets, so that its method is that of a sun which is up. Light paths stay with
 * the host; they are left to chance where they were not asked for by name. */
static bool choose_sun(Plan *plan, const RenderParams *params, Error *error) {
    Scene scene = *params->scene;
    scene_set_sun(&scene, 45, 0);
    if (!sun_choose(&plan->sun, params->sun_disk, &scene, error)) return false;
    if (!plan->sun.method->traces_light) return true;
    if (method_is_auto(params->sun_disk)) return method_choose(&plan->sun, METHOD_SUN, "sampled", error);
    return error_set(error, STATUS_USAGE,
                     "--sun-disk %s: a page traces no light paths from the sun; --sun-disk=sampled leaves "
                     "their light to chance",
                     plan->sun.text);
}

bool page_plan(Plan *plan, const RenderParams *params, Error *error) {
    const char *path = params->scene->file->path;
    if (!plan_make(plan, params, NULL, error) || !choose_sun(plan, params, error)) return false;
    plan->uncounted = true;
    if (plan->sequence.method->walks_chains)
        return error_set(error, STATUS_USAGE, "--sequence %s: a page has no Markov chains",
                         plan->sequence.text);
    Camera camera = camera_of(params->scene, plan_width(params), plan_height(params));
    Frame frame = frame_of(plan, params, &camera);
    for (int i = 0; picture_tables[i]; i++) {
        const ResourceKind *kind = picture_tables[i];
        if (kind->entry || page_stand_of(kind) || !resource_is_needed(kind, picture_tables, &frame)) continue;
        return error_set(
            error, STATUS_SCENE,
            "%s:%d: a page has no %s, which is read from a file: define scene_sphere() in its place", path,
            params->scene->file->spheres_line, kind->name + 4);
    }
    /* The page does not know where it will be opened. */
    return plan_fit_loops(plan, params, PLAN_LEAST_LOOP_LIMIT, error);
}
