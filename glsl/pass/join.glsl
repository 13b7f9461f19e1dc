#version 330 core
// Adds the film's second sum, of light that was traced from the lights, to its first, so that the window can show both as one film.

uniform sampler2D join_sum;
uniform sampler2D join_light;
// Divides the second sum by the number of light paths.
uniform float join_scale;

layout(location = 0) out vec4 joined;

void main() {
    vec4 sum = texelFetch(join_sum, ivec2(gl_FragCoord.xy), 0);
    vec4 light = texelFetch(join_light, ivec2(gl_FragCoord.xy), 0);
    joined = vec4(sum.rgb + join_scale * sum.a * light.rgb, sum.a);
}
