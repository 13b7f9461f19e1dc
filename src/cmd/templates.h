/* The files of scenes/templates/, of which the build makes strings. */
#pragma once

extern const char embedded_exact_glsl[], embedded_marched_glsl[], embedded_shadertoy_glsl[];
