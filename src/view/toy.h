/* A program written for Shadertoy: a file that defines mainImage() and no scene. Each frame sees the one
 * before as iChannel0. */
#pragma once

#include "gl/target.h"
#include "scene/scene_file.h"

#include <stdint.h>

typedef struct Toy {
    /* Empty if the file is no Shadertoy program. */
    Program program;
    Target target;
    /* The frame that is being drawn. The frame before is the target's front. */
    int frame;
    /* The next row of the frame. */
    int row;
    /* The measured speed. */
    double pixels_per_second;
    /* The frame's time, and the time since the frame before. */
    double time_s, delta_s;
    double mouse[4];
} Toy;

/* Replaces the program by the file's, and keeps the frame before. `toy` may be empty. If it fails with
 * STATUS_SCENE and "file:line: ...", `toy` is unchanged. */
MUST_CHECK bool toy_compile(Toy *toy, const Context *context, const SceneFile *file, Error *error);
void toy_destroy(Toy *toy);

/* Sets the size. If the size changes, the program starts at its first frame. */
MUST_CHECK bool toy_resize(Toy *toy, const Context *context, int width, int height, Error *error);
void toy_restart(Toy *toy);

/* Draws for about `seconds`, or until `stop` returns true. A frame may take several calls. It keeps the time
 * and the mouse that it began with. */
MUST_CHECK bool toy_draw(Toy *toy, double seconds, double time_s, const double mouse[4], bool (*stop)(void),
                         Error *error);

/* Returns the texture of the last complete frame. Its row 0 is at the bottom. */
GLuint toy_texture(const Toy *toy);
