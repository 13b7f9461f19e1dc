/* A table that programs read: textures that are filled when what they depend on has changed, and only then.
 *
 * The kinds of tables are data: each is a ResourceKind, in the file whose subject the table is. The functions
 * below create a set of tables and keep it up to date. They pass on the `frame`, from which tables are made,
 * without reading it: only the kinds and their user have its type. */
#pragma once

#include "gl/program.h"

enum { RESOURCE_TEXTURES = 2, RESOURCE_INPUTS = 5, MOST_RESOURCES = 32 };

typedef struct Resource Resource;
typedef struct ResourceKind ResourceKind;

struct ResourceKind {
    /* For errors and lists, such as "the sky's table". */
    const char *name;
    /* The library's file whose program draws it, with one output for each texture; NULL where compute() fills
     * it. Kinds with the same entry share the program, and differ by their inputs and uniforms. */
    const char *entry;
    /* The samplers through which programs read its textures; NULL for a texture that it does not have. */
    const char *samplers[RESOURCE_TEXTURES];
    /* GL_NEAREST or GL_LINEAR. */
    GLint filter;
    /* The kinds that are filled before this one, because `entry` or compute() reads them. */
    const ResourceKind *inputs[RESOURCE_INPUTS];
    /* The samplers through which `entry` reads the textures of an input, where they are not the input's own.
     */
    const char *input_samplers[RESOURCE_INPUTS][RESOURCE_TEXTURES];
    /* Whether a frame needs it even if no other table does. An input of a table that is needed is needed
     * too. */
    bool (*wanted)(const void *frame);
    /* Whether filling it by drawing may take longer than this frame may. It is then drawn in strips of rows,
     * between which resources_prepare_for() may stop. A table that each frame changes would never be finished
     * so. NULL where it never is. */
    bool (*in_steps)(const void *frame);
    /* The size in texels of a table that is drawn. */
    void (*size)(const void *frame, int *width, int *height);
    /* Appends the bytes on which the content depends, beside the inputs. NULL where it depends on the inputs
     * alone. */
    void (*key)(const void *frame, Text *key);
    /* Fills the textures of a table that is not drawn, with resource_upload(). */
    bool (*compute)(Resource *resource, const void *frame, Error *error);
    /* Adds the uniforms that programs need beside the textures; NULL where there are none. `resource` is NULL
     * or not filled yet if the uniforms are only listed. */
    void (*uniforms)(const Resource *resource, const void *frame, Uniforms *uniforms);
};

struct Resource {
    const ResourceKind *kind;
    const GlApi *gl;
    int max_texture_size;
    /* Empty for a kind without `entry`. It may be the program of an earlier resource, which then owns it. */
    Program program;
    bool borrows;
    GLuint textures[RESOURCE_TEXTURES], framebuffer;
    int width, height;
    const Resource *inputs[RESOURCE_INPUTS];
    /* What the content depends on, and whether all of it is there. While it is filled in steps, `row` is the
     * first row that is not drawn yet, at the speed that was measured last. */
    Text filled_for;
    bool whole;
    int row;
    double texels_per_second;
    /* The number of times that it was filled. */
    int fills;
    /* A number that compute() leaves for uniforms(), such as the number of entries in a list. */
    int entries;
};

typedef struct Resources {
    Resource *items[MOST_RESOURCES];
    int count;
} Resources;

/* make() writes the text of a program from one of the library's entry files. */
typedef struct ResourceTexts {
    bool (*make)(const void *data, const char *entry, GlslSource *source, Error *error);
    const void *data;
} ResourceTexts;

/* Creates the tables of `kinds` that the frame needs, and compiles their programs. `kinds` ends with NULL,
 * and inputs come before the kinds that read them. */
MUST_CHECK bool resources_create(Resources *resources, const Context *context,
                                 const ResourceKind *const *kinds, const void *frame,
                                 const ResourceTexts *texts, Error *error);
void resources_destroy(Resources *resources);

/* Whether the frame needs a table of that kind, by itself or as another table's input. */
bool resource_is_needed(const ResourceKind *kind, const ResourceKind *const *kinds, const void *frame);

/* Fills the tables whose content is out of date for this frame. `uniforms` holds the frame's uniforms; those
 * of the tables are added to it. The bound framebuffer and the program in use change. */
MUST_CHECK bool resources_prepare(Resources *resources, const void *frame, Uniforms *uniforms, Error *error);

/* The same, but only for about `seconds` (INFINITY for as long as it takes), and until `stop` (may be NULL)
 * returns true; both are looked at between strips of the tables in steps, of which at least one strip is
 * drawn. The next call goes on with it, and starts anew what has become out of date in between. `share` is
 * the part of these tables that is ready, weighted by texels. It is 1 if and only if everything is: before
 * that `uniforms` is not complete, and nothing may be drawn with the tables. */
MUST_CHECK bool resources_prepare_for(Resources *resources, const void *frame, Uniforms *uniforms,
                                      double seconds, bool (*stop)(void), double *share, Error *error);

/* Adds the tables' uniforms without filling the tables. */
void resources_uniforms(const Resources *resources, const void *frame, Uniforms *uniforms);

/* Sets the textures of the samplers that the program in use declares. */
void resources_give(const Resources *resources, const Program *program);

/* The table of that kind, or NULL if the set has none. */
Resource *resources_find(const Resources *resources, const ResourceKind *kind);

/* For compute(): sets the size and the content of texture i, 4 floats a texel, row 0 first. */
void resource_upload(Resource *resource, int i, int width, int height, const float *texels);

/* For compute(): reads texture i of a table that was drawn, 4 floats a texel, row 0 first. */
MUST_CHECK bool resource_read(const Resource *resource, int i, float *texels, Error *error);
