/* A target is what passes draw into: float textures on two sides. A pass reads the front side and writes the
 * back side; then the two change places. */
#pragma once

#include "base/archive.h"
#include "base/rectangle.h"
#include "gl/program.h"

enum { TARGET_TEXTURES = 7 };

typedef struct Target {
    const GlApi *gl;
    int width, height;
    /* RGBA32F, one for each output of the shader; 0 where there is none. */
    GLuint textures[2][TARGET_TEXTURES];
    GLuint framebuffer[2];
    int front;
    /* The bytes that were taken for it (base/budget.h). */
    size_t memory;
} Target;

/* Creates the target with both sides zero. `outputs` has a bit for each output of the shader that gets a
 * texture. A size beyond this OpenGL's limit, or one that needs more memory than is allowed, is
 * STATUS_USAGE. */
MUST_CHECK bool target_create(Target *target, const Context *context, int width, int height, unsigned outputs,
                              Error *error);
void target_destroy(Target *target);

/* Sets both sides to zero. */
void target_clear(Target *target);

/* The same for one side alone. */
void target_clear_front(Target *target);
void target_clear_back(Target *target);

/* The back side becomes what is drawn into. The front side's texture i becomes the sampler names[i] of the
 * program, which must be in use. A texture whose name is NULL is not read. */
void target_begin(const Target *target, const Program *program, const char *const *names);

/* Copies these regions from the front to the back, for a pass that does not draw there. */
void target_keep(Target *target, const Rectangle *regions, int count);

/* The back side becomes the front side. */
void target_swap(Target *target);

/* Reads the front side's texture i: 4 floats a texel, row 0 first. */
MUST_CHECK bool target_read(const Target *target, int i, float *rgba, Error *error);

/* Saves the front side's textures, or loads them. */
MUST_CHECK bool target_archive(Target *target, Archive *archive, Error *error);

/* Reads one pixel of the front side's texture i. */
MUST_CHECK bool target_read_pixel(const Target *target, int i, int x, int y, float rgba[4], Error *error);
