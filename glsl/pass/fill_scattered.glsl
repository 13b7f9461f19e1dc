#version 330 core
// The light of the open sky that mist scatters toward the eye, over its albedo, for each direction from the eye: the sum of the patches' radiance, weighed by the phase
// function. The sum is divided by the same sum for a sky of radiance 1. With it a uniform sky comes out exactly.
#include <mist-phase>
#include "mist/sky_table.glsl"

uniform sampler2D patch_lights;
uniform sampler2D patch_directions;
uniform int patch_columns;
uniform int patch_rows;
uniform vec3 scattered_size;
uniform float scattered_forward;

out vec4 scattered;

float scattered_phase(vec3 incoming, vec3 outgoing) {
    return henyey_pdf(scattered_forward, incoming, outgoing) * mist_phase_weight(scattered_forward, dot(incoming, outgoing));
}

void main() {
    vec3 incoming = scattered_direction(floor(gl_FragCoord.xy) / (vec2(scattered_size.x, scattered_size.y) - 1.0));
    vec4 sum = vec4(0.0);
    int row = 0;
    do {
        int column = 0;
        do {
            vec4 light = texelFetch(patch_lights, ivec2(column, row), 0);
            vec3 direction = texelFetch(patch_directions, ivec2(column, row), 0).xyz;
            // The patch on either side of the sun.
            sum += light * (scattered_phase(incoming, direction) + scattered_phase(incoming, vec3(direction.x, direction.y, -direction.z)));
            column += 1;
        } while (column < patch_columns);
        row += 1;
    } while (row < patch_rows);
    scattered = vec4(sum.rgb / sum.a, 1.0);
}
