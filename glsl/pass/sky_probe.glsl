#version 330 core
// The sky's radiance in a list of directions, one in each texel.
#include <sky>

uniform sampler2D probe_directions;

out vec4 radiance;

void main() {
    vec3 direction = texelFetch(probe_directions, ivec2(gl_FragCoord.xy), 0).xyz;
    radiance = vec4(sky_radiance(direction), 1.0);
}
