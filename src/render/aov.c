#include "render/aov.h"

#include "base/known.h"
#include "base/memory.h"
#include "base/text.h"
#include "gl/strips.h"
#include "render/inputs.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    unsigned kind;
} kind_names[] = {{"albedo", AOV_ALBEDO},   {"normal", AOV_NORMAL},     {"depth", AOV_DEPTH},
                  {"samples", AOV_SAMPLES}, {"variance", AOV_VARIANCE}, {"transmittance", AOV_TRANSMITTANCE}};
enum { KINDS = sizeof kind_names / sizeof *kind_names };

static const unsigned first_hit = AOV_ALBEDO | AOV_NORMAL | AOV_DEPTH | AOV_TRANSMITTANCE;
/* A bit for each output of aov.glsl. */
static const unsigned outputs = 7;
static const float no_depth = 1e10f;

static unsigned find_kind(const char *name, size_t length) {
    for (int i = 0; i < KINDS; i++) {
        if (strlen(kind_names[i].name) == length && strncmp(kind_names[i].name, name, length) == 0)
            return kind_names[i].kind;
    }
    return 0;
}

static bool unknown_kind(const char *name, size_t length, Error *error) {
    Known known = known_to(name, length);
    for (int i = 0; i < KINDS; i++) known_add(&known, kind_names[i].name);
    return known_fail(&known, STATUS_USAGE, error, "--aov: unknown '%.*s'", (int)length, name);
}

bool aov_parse(const char *list, unsigned *kinds, Error *error) {
    *kinds = 0;
    for (const char *name = list; name;) {
        size_t length = strcspn(name, ",");
        unsigned kind = find_kind(name, length);
        if (!kind) return unknown_kind(name, length, error);
        if (*kinds & kind)
            return error_set(error, STATUS_USAGE, "--aov: '%.*s' comes twice", (int)length, name);
        *kinds |= kind;
        name = name[length] ? name + length + 1 : NULL;
    }
    return true;
}

static bool create_program(Program *program, const Context *context, const RenderParams *params,
                           const Renderer *renderer, Error *error) {
    GlslSource source = {0};
    bool ok = pass_text(&aov_pass_entry, &renderer->plan, params, &source, error) &&
              program_create(program, &context->gl, &source, error);
    glsl_source_destroy(&source);
    return ok;
}

/* Collects the tables' uniforms only: the picture has filled the tables already. */
static bool tell(const Aov *aov, const RenderParams *params, const Renderer *renderer, Error *error) {
    Frame frame = frame_of(&renderer->plan, params, &renderer->camera);
    Uniforms uniforms = {0};
    frame_uniforms(&frame, &renderer->plan, renderer->seed, &uniforms);
    resources_uniforms(&renderer->tables, &frame, &uniforms);
    program_use(&aov->program);
    program_set(&aov->program, &uniforms);
    resources_give(&renderer->tables, &aov->program);
    uniforms_free(&uniforms);
    return gl_check(aov->program.gl, "setting up --aov", error);
}

bool aov_create(Aov *aov, unsigned kinds, const Context *context, const RenderParams *params,
                const Renderer *renderer, Error *error) {
    const Camera *camera = &renderer->camera;
    *aov = (Aov){.kinds = kinds, .first = (unsigned)renderer->first_sample, .area = renderer->area};
    if (!(kinds & first_hit)) return true;
    if (!create_program(&aov->program, context, params, renderer, error) ||
        !target_create(&aov->target, context, camera->width, camera->height, outputs, error)) {
        goto fail;
    }
    if (tell(aov, params, renderer, error)) return true;
fail:
    aov_destroy(aov);
    return false;
}

bool aov_restart(Aov *aov, const Context *context, const RenderParams *params, const Renderer *renderer,
                 Error *error) {
    const Camera *camera = &renderer->camera;
    Target *target = &aov->target;
    aov->samples = 0;
    aov->area = renderer->area;
    aov->pace.width = 0;
    if (camera->width == target->width && camera->height == target->height) {
        target_clear(target);
    } else {
        target_destroy(target);
        if (!target_create(target, context, camera->width, camera->height, outputs, error)) return false;
    }
    return tell(aov, params, renderer, error);
}

void aov_destroy(Aov *aov) {
    target_destroy(&aov->target);
    program_destroy(&aov->program);
    *aov = (Aov){0};
}

static void begin_group(const Aov *aov, unsigned group) {
    static const char *const names[] = {"aov_albedo", "aov_normal", "aov_mist"};
    program_use(&aov->program);
    program_set_uint(&aov->program, "first_sample", aov->first + aov->samples);
    program_set_uint(&aov->program, "group_samples", group);
    target_begin(&aov->target, &aov->program, names);
}

/* Returns false if it was stopped; then the layers are unchanged. */
static bool add_group(Aov *aov, unsigned group, bool (*stop)(void)) {
    begin_group(aov, group);
    Rectangle all = {0, 0, aov->target.width, aov->target.height};
    Strips strips = {.program = &aov->program,
                     .picture = all,
                     .regions = &aov->area,
                     .count = 1,
                     .samples = group,
                     .stop = stop};
    if (!strips_draw(&strips, &aov->pace)) return false;
    target_swap(&aov->target);
    aov->samples += group;
    return true;
}

bool aov_pass(Aov *aov, const Renderer *renderer, uint64_t samples, bool (*stop)(void), Error *error) {
    unsigned wanted = samples < AOV_MOST_SAMPLES ? (unsigned)samples : AOV_MOST_SAMPLES;
    bool stopped = stop && stop();
    if (!aov->program.id) return true;
    while (!stopped && aov->samples < wanted) {
        unsigned left = wanted - aov->samples;
        stopped =
            !add_group(aov, left < renderer->plan.group_samples ? left : renderer->plan.group_samples, stop);
    }
    return gl_check(aov->program.gl, "drawing --aov", error);
}

bool aov_complete(Aov *aov, Error *error) {
    if (!aov->program.id || aov->samples) return true;
    add_group(aov, 1, NULL);
    return gl_check(aov->program.gl, "drawing --aov", error);
}

bool aov_archive(Aov *aov, Archive *archive, Error *error) {
    if (!aov->program.id) return true;
    ARCHIVE(archive, aov->samples);
    return target_archive(&aov->target, archive, error);
}

bool aov_read_pixel(const Aov *aov, unsigned samples, int x, int y, AovPixel *pixel, Error *error) {
    Target swapped = aov->target;
    float albedo[4], normal[4];
    begin_group(aov, samples);
    program_draw(&aov->program, x, y, 1, 1);
    target_swap(&swapped);
    if (!target_read_pixel(&swapped, 0, x, y, albedo, error) ||
        !target_read_pixel(&swapped, 1, x, y, normal, error))
        return false;
    double hits = (double)albedo[3];
    *pixel =
        (AovPixel){.hits = hits / samples, .depth = hits > 0 ? (double)normal[3] / hits : (double)no_depth};
    for (int c = 0; c < 3; c++) pixel->albedo[c] = (double)albedo[c] / samples;
    return true;
}

/* The first three channels of the sums, divided by the number of samples. */
static void add_mean(const Aov *aov, const char *name, const char *channels, const float *sums,
                     Image *image) {
    size_t values = 3 * (size_t)image->width * (size_t)image->height;
    float *data = image_add_layer(image, name, channels);
    for (size_t i = 0; aov->samples && i < values; i++)
        data[i] = sums[i / 3 * 4 + i % 3] / (float)aov->samples;
}

static void add_depth(const float *albedo, const float *normal, Image *image) {
    size_t pixels = (size_t)image->width * (size_t)image->height;
    float *data = image_add_layer(image, "", "Z");
    for (size_t i = 0; i < pixels; i++) {
        float hits = albedo[4 * i + 3];
        data[i] = hits > 0 ? normal[4 * i + 3] / hits : no_depth;
    }
}

static bool add_transmittance(const Aov *aov, Image *image, Error *error) {
    size_t pixels = (size_t)image->width * (size_t)image->height;
    float *sums = memory_get(4 * pixels, sizeof *sums);
    bool ok = target_read(&aov->target, 2, sums, error);
    float *data = image_add_layer(image, "transmittance", "Y");
    for (size_t i = 0; ok && aov->samples && i < pixels; i++) data[i] = sums[4 * i] / (float)aov->samples;
    free(sums);
    return ok;
}

static bool read_first_hit(const Aov *aov, Image *image, Error *error) {
    size_t values = 4 * (size_t)image->width * (size_t)image->height;
    float *albedo = memory_get(values, sizeof *albedo), *normal = memory_get(values, sizeof *normal);
    bool ok = target_read(&aov->target, 0, albedo, error) && target_read(&aov->target, 1, normal, error);
    if (ok && aov->kinds & AOV_ALBEDO) add_mean(aov, "albedo", "RGB", albedo, image);
    if (ok && aov->kinds & AOV_NORMAL) add_mean(aov, "normal", "XYZ", normal, image);
    if (ok && aov->kinds & AOV_DEPTH) add_depth(albedo, normal, image);
    if (ok && aov->kinds & AOV_TRANSMITTANCE) ok = add_transmittance(aov, image, error);
    free(albedo);
    free(normal);
    return ok;
}

bool aov_read(const Aov *aov, const Film *film, Image *image, Error *error) {
    if (aov->kinds & first_hit && !read_first_hit(aov, image, error)) return false;
    if (aov->kinds & AOV_SAMPLES && !film_read_samples(film, image_add_layer(image, "samples", "Y"), error)) {
        return false;
    }
    return !(aov->kinds & AOV_VARIANCE) ||
           film_read_variance(film, image_add_layer(image, "variance", "RGB"), error);
}

float *aov_variance(const Aov *aov, const Image *image) {
    /* aov_read() adds this layer last. */
    return aov->kinds & AOV_VARIANCE ? image->layers[image->layer_count - 1].data : NULL;
}
