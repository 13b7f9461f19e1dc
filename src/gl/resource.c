#include "gl/resource.h"

#include "base/clock.h"
#include "base/memory.h"
#include "gl/strips.h"
#include "gl/texture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool resource_is_needed(const ResourceKind *kind, const ResourceKind *const *kinds, const void *frame) {
    if (kind->wanted(frame)) return true;
    for (const ResourceKind *const *user = kinds; *user; user++) {
        for (int i = 0; i < RESOURCE_INPUTS; i++) {
            if ((*user)->inputs[i] == kind && resource_is_needed(*user, kinds, frame)) return true;
        }
    }
    return false;
}

static void destroy(Resource *resource) {
    const GlApi *gl = resource->gl;
    if (resource->framebuffer) gl->DeleteFramebuffers(1, &resource->framebuffer);
    gl->DeleteTextures(RESOURCE_TEXTURES, resource->textures);
    if (!resource->borrows) program_destroy(&resource->program);
    text_free(&resource->filled_for);
    free(resource);
}

/* Creates a framebuffer whose outputs are the textures. */
static void create_framebuffer(Resource *resource) {
    GLenum targets[RESOURCE_TEXTURES];
    const GlApi *gl = resource->gl;
    gl->GenFramebuffers(1, &resource->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, resource->framebuffer);
    for (int i = 0; i < RESOURCE_TEXTURES; i++) {
        targets[i] = resource->textures[i] ? GL_COLOR_ATTACHMENT0 + (GLenum)i : GL_NONE;
        if (resource->textures[i])
            gl->FramebufferTexture2D(GL_FRAMEBUFFER, targets[i], GL_TEXTURE_2D, resource->textures[i], 0);
    }
    gl->DrawBuffers(RESOURCE_TEXTURES, targets);
}

static bool create_program(Resource *resource, const Resources *before, const ResourceTexts *texts,
                           Error *error) {
    GlslSource source = {0};
    for (int i = 0; i < before->count; i++) {
        const Resource *other = before->items[i];
        if (!other->kind->entry || strcmp(other->kind->entry, resource->kind->entry) != 0) continue;
        resource->program = other->program;
        resource->borrows = true;
        return true;
    }
    bool ok = texts->make(texts->data, resource->kind->entry, &source, error) &&
              program_create(&resource->program, resource->gl, &source, error);
    glsl_source_destroy(&source);
    return ok;
}

static bool create(Resource *resource, const Resources *before, const ResourceTexts *texts, Error *error) {
    const ResourceKind *kind = resource->kind;
    for (int i = 0; i < RESOURCE_TEXTURES; i++) {
        if (kind->samplers[i]) resource->textures[i] = texture_create(resource->gl, 1, 1, kind->filter, NULL);
    }
    if (!kind->entry) return gl_check(resource->gl, kind->name, error);
    create_framebuffer(resource);
    return create_program(resource, before, texts, error) && gl_check(resource->gl, kind->name, error);
}

bool resources_create(Resources *resources, const Context *context, const ResourceKind *const *kinds,
                      const void *frame, const ResourceTexts *texts, Error *error) {
    *resources = (Resources){0};
    for (const ResourceKind *const *kind = kinds; *kind; kind++) {
        if (!resource_is_needed(*kind, kinds, frame)) continue;
        Resource *resource = memory_get(1, sizeof *resource);
        *resource =
            (Resource){.kind = *kind, .gl = &context->gl, .max_texture_size = context->max_texture_size};
        for (int i = 0; i < RESOURCE_INPUTS; i++)
            resource->inputs[i] = resources_find(resources, (*kind)->inputs[i]);
        bool ok = create(resource, resources, texts, error);
        resources->items[resources->count++] = resource;
        if (ok) continue;
        resources_destroy(resources);
        return false;
    }
    return true;
}

void resources_destroy(Resources *resources) {
    for (int i = 0; i < resources->count; i++) destroy(resources->items[i]);
    *resources = (Resources){0};
}

Resource *resources_find(const Resources *resources, const ResourceKind *kind) {
    for (int i = 0; i < resources->count; i++) {
        if (resources->items[i]->kind == kind) return resources->items[i];
    }
    return NULL;
}

/* When filling in steps has to end. */
typedef struct Step {
    double end;
    bool (*stop)(void);
    bool over;
} Step;

/* A table that this OpenGL cannot have is refused before any other one is changed. */
static bool check_sizes(const Resources *resources, const void *frame, Error *error) {
    for (int i = 0; i < resources->count; i++) {
        const Resource *resource = resources->items[i];
        int width, height, most = resource->max_texture_size;
        if (!resource->kind->entry) continue;
        resource->kind->size(frame, &width, &height);
        if (width <= most && height <= most) continue;
        return error_set(error, STATUS_USAGE, "%s: it needs textures of %dx%d, this OpenGL's limit is %d",
                         resource->kind->name, width, height, most);
    }
    return true;
}

static void resize(Resource *resource, const void *frame) {
    int width, height;
    resource->kind->size(frame, &width, &height);
    if (width == resource->width && height == resource->height) return;
    for (int i = 0; i < RESOURCE_TEXTURES; i++) {
        if (resource->textures[i]) texture_resize(resource->gl, resource->textures[i], width, height, NULL);
    }
    resource->width = width;
    resource->height = height;
}

static bool in_steps(const Resource *resource, const void *frame) {
    return resource->kind->in_steps && resource->kind->in_steps(frame);
}

/* Draws strips of at most a tenth of a second. */
static void draw_rows(Resource *resource, Step *step) {
    static const double first_guess = 2e4, longest_s = 0.3;
    double left = step->end - clock_seconds();
    if (!(resource->texels_per_second > 0)) resource->texels_per_second = first_guess;
    do {
        strips_draw_for(&resource->program, resource->width, resource->height, &resource->row,
                        &resource->texels_per_second, fmin(fmax(left, 0), longest_s), step->stop);
        left = step->end - clock_seconds();
        step->over = left <= 0 || (step->stop && step->stop());
    } while (resource->row < resource->height && !step->over);
}

/* The program may read only the tables in `before`. It may have been another table's since the last step. */
static bool draw(Resource *resource, const Resources *before, const void *frame, const Uniforms *uniforms,
                 Step *step, Error *error) {
    const GlApi *gl = resource->gl;
    resize(resource, frame);
    program_use(&resource->program);
    program_set(&resource->program, uniforms);
    resources_give(before, &resource->program);
    for (int i = 0; i < RESOURCE_INPUTS * RESOURCE_TEXTURES; i++) {
        int input = i / RESOURCE_TEXTURES, t = i % RESOURCE_TEXTURES;
        const char *sampler = resource->kind->input_samplers[input][t];
        if (sampler) program_set_texture(&resource->program, sampler, resource->inputs[input]->textures[t]);
    }
    if (!program_check(&resource->program, error)) return false;
    gl->BindFramebuffer(GL_FRAMEBUFFER, resource->framebuffer);
    gl->Viewport(0, 0, resource->width, resource->height);
    if (in_steps(resource, frame)) {
        draw_rows(resource, step);
    } else {
        program_draw(&resource->program, 0, 0, resource->width, resource->height);
        resource->row = resource->height;
    }
    return true;
}

/* Writes what the content depends on: the frame's part, and how often each input was filled. */
static void write_key(const Resource *resource, const void *frame, Text *key) {
    if (resource->kind->key) resource->kind->key(frame, key);
    for (int i = 0; i < RESOURCE_INPUTS; i++) {
        if (resource->inputs[i])
            text_append(key, &resource->inputs[i]->fills, sizeof resource->inputs[i]->fills);
    }
}

static bool same_bytes(const Text *a, const Text *b) {
    return a->size == b->size && (a->size == 0 || memcmp(a->data, b->data, a->size) == 0);
}

/* A table that is not drawn has the size that compute() gives it. */
static bool has_size(const Resource *resource, const void *frame) {
    int width, height;
    if (!resource->kind->entry) return true;
    resource->kind->size(frame, &width, &height);
    return width == resource->width && height == resource->height;
}

/* Finds the tables that are out of date for this frame. Those that read them are so too. */
static void find_stale(Resources *resources, const void *frame) {
    for (int i = 0; i < resources->count; i++) {
        Resource *resource = resources->items[i];
        Text key = {0};
        write_key(resource, frame, &key);
        bool same = same_bytes(&key, &resource->filled_for);
        same &= has_size(resource, frame);
        for (int k = 0; k < RESOURCE_INPUTS; k++) same &= !resource->inputs[k] || resource->inputs[k]->whole;
        if (!same) {
            resource->whole = false;
            resource->row = 0;
        }
        text_free(&key);
    }
}

static bool prepare(Resource *resource, const Resources *before, const void *frame, Uniforms *uniforms,
                    Step *step, Error *error) {
    const ResourceKind *kind = resource->kind;
    bool stale = !resource->whole;
    if (stale && kind->compute && !kind->compute(resource, frame, error)) return false;
    if (kind->uniforms) kind->uniforms(resource, frame, uniforms);
    if (!stale) return true;
    if (kind->entry && !draw(resource, before, frame, uniforms, step, error)) return false;
    if (!gl_check(resource->gl, kind->name, error)) return false;
    text_free(&resource->filled_for);
    write_key(resource, frame, &resource->filled_for);
    if (kind->entry && resource->row < resource->height) return true;
    resource->whole = true;
    resource->row = 0;
    resource->fills++;
    return true;
}

static double share_ready(const Resources *resources, const void *frame) {
    double ready = 0, all = 0;
    for (int i = 0; i < resources->count; i++) {
        const Resource *resource = resources->items[i];
        int width, height;
        if (!in_steps(resource, frame)) continue;
        resource->kind->size(frame, &width, &height);
        all += (double)width * height;
        ready += (double)width * (resource->whole ? height : resource->row);
    }
    return ready / all;
}

bool resources_prepare_for(Resources *resources, const void *frame, Uniforms *uniforms, double seconds,
                           bool (*stop)(void), double *share, Error *error) {
    Step step = {.end = clock_seconds() + 0.9 * seconds, .stop = stop};
    int ready = 0;
    if (!check_sizes(resources, frame, error)) return false;
    find_stale(resources, frame);
    for (; ready < resources->count; ready++) {
        Resource *resource = resources->items[ready];
        Resources before = *resources;
        before.count = ready;
        if (step.over && !resource->whole && in_steps(resource, frame)) break;
        if (!prepare(resource, &before, frame, uniforms, &step, error)) return false;
        if (!resource->whole) break;
    }
    *share = ready < resources->count ? share_ready(resources, frame) : 1;
    return true;
}

bool resources_prepare(Resources *resources, const void *frame, Uniforms *uniforms, Error *error) {
    double share;
    return resources_prepare_for(resources, frame, uniforms, INFINITY, NULL, &share, error);
}

void resources_uniforms(const Resources *resources, const void *frame, Uniforms *uniforms) {
    for (int i = 0; i < resources->count; i++) {
        const ResourceKind *kind = resources->items[i]->kind;
        if (kind->uniforms) kind->uniforms(resources->items[i], frame, uniforms);
    }
}

void resources_give(const Resources *resources, const Program *program) {
    for (int i = 0; i < resources->count; i++) {
        const Resource *resource = resources->items[i];
        for (int t = 0; t < RESOURCE_TEXTURES; t++) {
            const char *sampler = resource->kind->samplers[t];
            if (sampler && program_declares(program, sampler))
                program_set_texture(program, sampler, resource->textures[t]);
        }
    }
}

void resource_upload(Resource *resource, int i, int width, int height, const float *texels) {
    texture_resize(resource->gl, resource->textures[i], width, height, texels);
}

bool resource_read(const Resource *resource, int i, float *texels, Error *error) {
    const GlApi *gl = resource->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, resource->framebuffer);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)i);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, resource->width, resource->height, GL_RGBA, GL_FLOAT, texels);
    return gl_check(gl, resource->kind->name, error);
}
