/* A renderer in the test's own process, set up by words of the command line: pictures of many seeds, and the
 * shaders compiled once. */
#pragma once

#include "cmd/options.h"
#include "gl/context.h"
#include "image/image.h"
#include "render/renderer.h"

typedef struct Studio {
    Context context;
    Options options;
    Scene scene;
    RenderParams params;
    Renderer renderer;
    /* What the options point into. */
    char words[1024], scene_path[1024];
} Studio;

/* `arguments` are those of `render`, without quotes. Their --spp is scaled by support_samples(). Ends the
 * test where there is no OpenGL, and fails it for what is wrong with the scene. */
void studio_open(Studio *studio, const char *scene, const char *arguments);
void studio_close(Studio *studio);

/* Renders with this seed. */
Image studio_picture(Studio *studio, unsigned seed);
