/* A table that programs look things up in: textures that are filled when what they depend on has changed, and
 * only then.
 *
 * What kinds of table there are is data: a ResourceKind for each, in the file that the table is about. A set
 * of them is made and kept up to date by the same few functions. What tables are made from, the `frame`, is
 * known to the kinds and to their user alone. */
#pragma once

#include "gl/program.h"

enum { RESOURCE_TEXTURES = 2, RESOURCE_INPUTS = 2, MOST_RESOURCES = 16 };

typedef struct Resource Resource;
typedef struct ResourceKind ResourceKind;

struct ResourceKind {
    /* For errors and lists: "the sky's table". */
    const char *name;
    /* The library's file that draws it, an output for each texture; NULL where compute() fills it. */
    const char *entry;
    /* The samplers under which programs read its textures; NULL for a texture that it does not have. */
    const char *samplers[RESOURCE_TEXTURES];
    /* GL_NEAREST or GL_LINEAR. */
    GLint filter;
    /* The kinds that are made before it because `entry` or compute() reads them. */
    const ResourceKind *inputs[RESOURCE_INPUTS];
    /* Whether a frame needs it for its own sake. An input of a table that is needed is needed too. */
    bool (*wanted)(const void *frame);
    /* Texels of a table that is drawn. */
    void (*size)(const void *frame, int *width, int *height);
    /* Appends the bytes that the content depends on, beside the inputs. NULL where it depends on the inputs
     * alone. */
    void (*key)(const void *frame, Text *key);
    /* Fills the textures of a table that is not drawn, by resource_upload(). */
    bool (*compute)(Resource *resource, const void *frame, Error *error);
    /* Adds what programs have to know beside the textures. NULL where that is nothing. `resource` is NULL, or
     * not filled yet, where the uniforms are only listed. */
    void (*uniforms)(const Resource *resource, const void *frame, Uniforms *uniforms);
};

struct Resource {
    const ResourceKind *kind;
    const GlApi *gl;
    int max_texture_size;
    /* Empty where there is no entry. */
    Program program;
    GLuint textures[RESOURCE_TEXTURES], framebuffer;
    int width, height;
    const Resource *inputs[RESOURCE_INPUTS];
    Text filled_for;
    /* How often it was filled. */
    int fills;
    /* For compute(), of what uniforms() tells: such as how many entries a list has. */
    int entries;
};

typedef struct Resources {
    Resource *items[MOST_RESOURCES];
    int count;
} Resources;

/* Makes the text of a program from a library's entry file. */
typedef struct ResourceTexts {
    bool (*make)(const void *data, const char *entry, GlslSource *source, Error *error);
    const void *data;
} ResourceTexts;

/* Creates the tables of `kinds` (ends with NULL; inputs come before their users) that the frame needs, and
 * compiles their programs. */
MUST_CHECK bool resources_create(Resources *resources, const Context *context,
                                 const ResourceKind *const *kinds, const void *frame,
                                 const ResourceTexts *texts, Error *error);
void resources_destroy(Resources *resources);

/* Whether the frame needs a table of that kind, for its own sake or as another's input. */
bool resource_is_needed(const ResourceKind *kind, const ResourceKind *const *kinds, const void *frame);

/* Fills the tables that have to be filled for this frame. `uniforms` holds what the frame tells all programs;
 * what the tables tell is added to it. The framebuffer that is bound and the program in use change. */
MUST_CHECK bool resources_prepare(Resources *resources, const void *frame, Uniforms *uniforms, Error *error);

/* Adds what the tables tell, as they are. */
void resources_uniforms(const Resources *resources, const void *frame, Uniforms *uniforms);

/* Gives the program in use the textures that it declares. */
void resources_give(const Resources *resources, const Program *program);

/* The table of that kind, or NULL. */
Resource *resources_find(const Resources *resources, const ResourceKind *kind);

/* For compute(): gives texture i a size and its content, 4 floats a texel, row 0 first. */
void resource_upload(Resource *resource, int i, int width, int height, const float *texels);

/* For compute(): texture i of a table that was drawn, read back. */
MUST_CHECK bool resource_read(const Resource *resource, int i, float *texels, Error *error);
