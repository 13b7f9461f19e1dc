#include "gl/resource.h"

#include "base/memory.h"
#include "gl/texture.h"

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

static bool resize(Resource *resource, const void *frame, Error *error) {
    int width, height, most = resource->max_texture_size;
    resource->kind->size(frame, &width, &height);
    if (width == resource->width && height == resource->height) return true;
    if (width > most || height > most) {
        return error_set(error, STATUS_USAGE, "%s: it needs textures of %dx%d, this OpenGL's limit is %d",
                         resource->kind->name, width, height, most);
    }
    for (int i = 0; i < RESOURCE_TEXTURES; i++) {
        if (resource->textures[i]) texture_resize(resource->gl, resource->textures[i], width, height, NULL);
    }
    resource->width = width;
    resource->height = height;
    return true;
}

/* The program may read only the tables in `before`. */
static bool draw(Resource *resource, const Resources *before, const void *frame, const Uniforms *uniforms,
                 Error *error) {
    const GlApi *gl = resource->gl;
    if (!resize(resource, frame, error)) return false;
    program_use(&resource->program);
    program_set(&resource->program, uniforms);
    resources_give(before, &resource->program);
    for (int i = 0; i < RESOURCE_INPUTS; i++) {
        const char *sampler = resource->kind->input_samplers[i];
        if (sampler) program_set_texture(&resource->program, sampler, resource->inputs[i]->textures[0]);
    }
    if (!program_check(&resource->program, error)) return false;
    gl->BindFramebuffer(GL_FRAMEBUFFER, resource->framebuffer);
    gl->Viewport(0, 0, resource->width, resource->height);
    program_draw(&resource->program, 0, 0, resource->width, resource->height);
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

static bool prepare(Resource *resource, const Resources *before, const void *frame, Uniforms *uniforms,
                    Error *error) {
    const ResourceKind *kind = resource->kind;
    Text key = {0};
    bool ok = true;
    write_key(resource, frame, &key);
    bool stale = !resource->fills || !same_bytes(&key, &resource->filled_for);
    if (stale && kind->compute) ok = kind->compute(resource, frame, error);
    if (ok && kind->uniforms) kind->uniforms(resource, frame, uniforms);
    if (ok && stale && kind->entry) ok = draw(resource, before, frame, uniforms, error);
    if (ok && stale) ok = gl_check(resource->gl, kind->name, error);
    if (ok && stale) {
        text_free(&resource->filled_for);
        resource->filled_for = key;
        key = (Text){0};
        resource->fills++;
    }
    text_free(&key);
    return ok;
}

bool resources_prepare(Resources *resources, const void *frame, Uniforms *uniforms, Error *error) {
    for (int i = 0; i < resources->count; i++) {
        Resources before = *resources;
        before.count = i;
        if (!prepare(resources->items[i], &before, frame, uniforms, error)) return false;
    }
    return true;
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
