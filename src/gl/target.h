/* What passes draw into: float textures on two sides. A pass reads the front and writes the back, then they
 * change places. */
#pragma once

#include "base/rectangle.h"
#include "gl/program.h"

enum { TARGET_TEXTURES = 5 };

typedef struct Target {
    const GlApi *gl;
    int width, height;
    GLuint textures[2][TARGET_TEXTURES]; /* RGBA32F, for the shader's output of the same number; 0 is none */
    GLuint framebuffer[2];
    int front;
} Target;

/* Cleared. `outputs`: a bit for each of the shader's outputs that there is a texture for. STATUS_USAGE for a
 * size beyond this OpenGL's. */
MUST_CHECK bool target_create(Target *target, const Context *context, int width, int height, unsigned outputs,
                              Error *error);
void target_destroy(Target *target);

/* Zeroes both sides. */
void target_clear(Target *target);

/* Makes the back side what is drawn into, and the front side's texture i the sampler names[i]. The program
 * must be in use. */
void target_begin(const Target *target, const Program *program, const char *const *names);

/* Copies these regions from the front to the back, for passes that do not draw there. */
void target_keep(Target *target, const Rectangle *regions, int count);

/* The back becomes the front. */
void target_swap(Target *target);

/* The front's texture i: 4 floats a texel, row 0 first. */
MUST_CHECK bool target_read(const Target *target, int i, float *rgba, Error *error);

/* The front's texture i at one pixel. */
MUST_CHECK bool target_read_pixel(const Target *target, int i, int x, int y, float rgba[4], Error *error);
