#version 330 core
// The spheres that the scene's function scene_sphere() makes, one in each texel.
#include "scene.glsl"
#include <inputs>
#include <scene>
#include "light/lambert.glsl"
#include "pass/spheres.glsl"

uniform int fill_count;
// The columns of the texture.
uniform int fill_columns;

layout(location = 0) out vec4 fill_sphere;

vec4 scene_sphere(int i);

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int i = texel.y * fill_columns + texel.x;
    fill_sphere = i < fill_count ? scene_sphere(i) : vec4(0.0);
}
