#version 330 core
// A program written for Shadertoy, which defines mainImage(). iChannel0 is the picture before this one, and the other channels are
// black. iFrame is the picture's number. Row 0 is the bottom, as in Shadertoy.
#include "pass/shadertoy_uniforms.glsl"
#include <scene>

layout(location = 0) out vec4 shadertoy_next;

void main() {
    vec4 color = vec4(0.0, 0.0, 0.0, 1.0);
    mainImage(color, gl_FragCoord.xy);
    shadertoy_next = color;
}
