/* The command line that makes a picture of the window again. */
#pragma once

#include "base/text.h"
#include "render/renderer.h"

/* `magichour render SCENE -o FILE.exr ...` with all that differs from what the scene's file says. */
void view_command(const Scene *scene, const Renderer *renderer, int max_hits, Text *command);
