/* The command line that makes a picture of the window again. */
#pragma once

#include "base/text.h"
#include "render/renderer.h"

typedef struct CommandParams {
    const Scene *scene;
    const Renderer *renderer;
    int max_hits;
    /* NULL where the GLSL library is the one beside the program. */
    const char *glsl_dir;
} CommandParams;

/* `magichour render SCENE -o picture.exr ...` with all that differs from what the scene's file says, for a
 * shell. */
void view_command(const CommandParams *params, Text *command);
