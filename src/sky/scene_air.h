/* The atmosphere's air between a scene's surfaces. */
#pragma once

#include "gl/program.h"
#include "scene/atmosphere.h"

/* Sets the uniforms of glsl/pass/air.glsl. */
void scene_air_uniforms(const Atmosphere *atmosphere, Uniforms *uniforms);

/* What the air does with light, in the picture's three channels, 1/m. */
typedef struct SceneAir {
    double rayleigh_scatter[3], mie_scatter[3], mie_extinction[3], ozone_absorb[3];
} SceneAir;

/* With a spectrum, a channel's coefficient is the mean over the wavelengths, weighed by what each adds to the
 * channel of white light. So thin air changes white light as the spectrum would. */
SceneAir scene_air(const Atmosphere *atmosphere);
