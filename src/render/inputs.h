/* Shadertoy's inputs for scenes that want them: iResolution, iTime, iFrame and iMouse, declared for a scene
 * that names one without declaring it. */
#pragma once

#include "gl/program.h"
#include "scene/scene.h"

/* A bit for each that this scene, flattened alone, is owed. */
unsigned inputs_wanted(const GlslSource *scene);

void inputs_declare(unsigned wanted, Text *declarations);

/* Tells `program`, which is in use, of a picture of this size, all but iFrame: groups of samples since it
 * began. */
void inputs_set(const Program *program, const Scene *scene, int width, int height);
