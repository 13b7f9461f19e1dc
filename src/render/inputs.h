/* The inputs of scenes: Shadertoy's iResolution, iTime, iFrame and iMouse, which are declared for a scene
 * that uses one without declaring it, and the scene's own parameters. */
#pragma once

#include "gl/uniforms.h"
#include "scene/glsl_source.h"
#include "sky/frame.h"

/* A bit for each input that must be declared for this scene. `scene` is its flattened text alone. */
unsigned inputs_wanted(const GlslSource *scene);

void inputs_declare(unsigned wanted, Text *declarations);

/* Adds the uniforms of programs that include the scene: the parameters and all inputs but iFrame, which
 * counts the groups of samples since the picture began. */
void inputs_uniforms(const Frame *frame, Uniforms *uniforms);
