#version 330 core
// Adds light to the film at the pixels that it reached. The textures hold one point in each texel: its place, in pixels from the
// picture's top left corner, and its light. Blending adds the points in their order.
#include "math/finite.glsl"

// The vertex shader reads these. It is part of the host (src/gl/program.c).
uniform sampler2D splat_places;
uniform sampler2D splat_lights;
uniform vec3 splat_size;

flat in vec4 splat_light;

layout(location = 0) out vec4 splat_sum;

void main() {
    bool finite = is_finite(vec3(splat_light));
    splat_sum = finite ? vec4(vec3(splat_light), 1.0) : vec4(0.0);
}
