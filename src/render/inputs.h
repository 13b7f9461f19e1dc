/* Shadertoy's inputs for scenes that want them: iResolution, iTime, iFrame and iMouse, declared for a scene
 * that names one without declaring it. And the scene's own parameters. */
#pragma once

#include "gl/uniforms.h"
#include "scene/glsl_source.h"
#include "sky/frame.h"

/* A bit for each that this scene, flattened alone, is owed. */
unsigned inputs_wanted(const GlslSource *scene);

void inputs_declare(unsigned wanted, Text *declarations);

/* What programs that hold the scene are told: the inputs, all but iFrame (groups of samples since the picture
 * began), and the parameters. */
void inputs_uniforms(const Frame *frame, Uniforms *uniforms);
