#include "cmd/pass_json.h"
#include "source/glsl_log.h"

#include "base/json.h"
#include "source/glsl_uniforms.h"

#include <stdlib.h>

static const char *const type_names[] = {"float", "int", "uint", "vec3", "vec4", "float[]"};
static const int components[] = {1, 1, 1, 3, 4, 1};

static void print_pass(const Pass *pass, int order, const Frame *frame, const GlslSource *source,
                       FILE *file) {
    int width = frame->camera.width, height = frame->camera.height;
    if (pass->fills) pass->fills->size(frame, &width, &height);
    char *text = glsl_source_plain(source);
    Json json = json_begin();
    json_text(&json, "pass", pass->name);
    json_count(&json, "order", (uint64_t)order);
    json_text(&json, "entry", pass->entry);
    json_text(&json, "fills", pass->fills ? pass->fills->name : "");
    json_count(&json, "width", (uint64_t)width);
    json_count(&json, "height", (uint64_t)height);
    json_text(&json, "text", text);
    json_end(&json, file);
    free(text);
}

static void print_uniform(const Pass *pass, const Uniform *uniform, FILE *file) {
    bool many = uniform->type == UNIFORM_FLOATS;
    Json json = json_begin();
    json_text(&json, "pass", pass->name);
    json_text(&json, "uniform", uniform->name);
    json_text(&json, "type", type_names[uniform->type]);
    json_text(&json, "declared_in", uniform->file ? uniform->file : "");
    json_numbers(&json, "values", many ? uniform->many : uniform->values,
                 many ? uniform->count : components[uniform->type]);
    json_end(&json, file);
}

/* Chooses the uniforms as program_set() does, before there is a program. */
static void print_uniforms(const Pass *pass, const GlslSource *source, const GlslUniforms *declared,
                           const Uniforms *uniforms, FILE *file) {
    for (int i = 0; i < uniforms->count; i++) {
        const Uniform *uniform = &uniforms->items[i];
        bool taken = uniform->file ? glsl_source_includes(source, uniform->file)
                                   : glsl_uniforms_find(declared, uniform->name) != NULL;
        if (taken) print_uniform(pass, uniform, file);
    }
}

static void print_samplers(const Pass *pass, const GlslUniforms *declared, FILE *file) {
    for (const ResourceKind *const *kind = picture_tables; *kind; kind++) {
        for (int i = 0; i < RESOURCE_TEXTURES; i++) {
            const char *sampler = (*kind)->samplers[i];
            if (!sampler || !glsl_uniforms_find(declared, sampler)) continue;
            Json json = json_begin();
            json_text(&json, "pass", pass->name);
            json_text(&json, "sampler", sampler);
            json_text(&json, "reads", (*kind)->name);
            json_count(&json, "output", (uint64_t)i);
            json_end(&json, file);
        }
    }
}

static bool print(const Pass *pass, int order, const Plan *plan, const RenderParams *params,
                  const Frame *frame, const Uniforms *uniforms, FILE *file, Error *error) {
    GlslSource source = {0};
    if (!pass_text(pass, plan, params, &source, error)) return false;
    GlslUniforms declared = glsl_uniforms(text_string(&source.text));
    print_pass(pass, order, frame, &source, file);
    print_uniforms(pass, &source, &declared, uniforms, file);
    print_samplers(pass, &declared, file);
    glsl_uniforms_free(&declared);
    glsl_source_destroy(&source);
    return true;
}

bool pass_json_print(const Plan *plan, const RenderParams *params, FILE *file, Error *error) {
    Camera camera = camera_of(params->scene, plan_width(params), plan_height(params));
    Frame frame = frame_of(plan, params, &camera);
    PassList list = pass_list(plan, params);
    Uniforms uniforms = {0};
    bool ok = true;
    frame_uniforms(&frame, plan, params->seed, &uniforms);
    for (const ResourceKind *const *kind = picture_tables; *kind; kind++) {
        if ((*kind)->uniforms && resource_is_needed(*kind, picture_tables, &frame))
            (*kind)->uniforms(NULL, &frame, &uniforms);
    }
    for (int i = 0; ok && i < list.count; i++)
        ok = print(&list.passes[i], i, plan, params, &frame, &uniforms, file, error);
    uniforms_free(&uniforms);
    return ok;
}
