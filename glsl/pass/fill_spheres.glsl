#version 330 core
// The spheres that a scene makes itself, one a texel.
#include "scene.glsl"
#include <inputs>
#include <scene>
#include "light/lambert.glsl"
#include "pass/spheres.glsl"

uniform int fill_count;
uniform int fill_columns; // of the texture

layout(location = 0) out vec4 fill_sphere;

vec4 scene_sphere(int i);

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int i = texel.y * fill_columns + texel.x;
    fill_sphere = i < fill_count ? scene_sphere(i) : vec4(0.0);
}
