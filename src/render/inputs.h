/* The inputs of scenes: Shadertoy's iResolution, iTime, iFrame and iMouse, which are declared for a scene
 * that uses one without declaring it, and the scene's own parameters. */
#pragma once

#include "gl/uniforms.h"
#include "sky/frame.h"

/* Adds the values of the scene's parameters. */
void inputs_parameters(const Scene *scene, Uniforms *uniforms);

/* Adds the uniforms of programs that include the scene: the parameters and all inputs but iFrame, which
 * counts the groups of samples since the picture began. */
void inputs_uniforms(const Frame *frame, Uniforms *uniforms);
