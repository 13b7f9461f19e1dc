/* The command lines that make a picture of the window again, and that open a window which shows it. */
#pragma once

#include "base/text.h"
#include "render/renderer.h"
#include "view/state.h"

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

typedef struct LinkParams {
    const Scene *scene;
    const MethodNames *methods;
    /* The window's size, the seed, and the number of hits that a path may have, or 0 for the usual. */
    int width, height;
    unsigned seed;
    int max_hits;
    const char *glsl_dir;
} LinkParams;

/* `magichour view SCENE ...` with all that differs from what the scene's file says, for a shell. */
void view_link(const LinkParams *params, Text *command);
