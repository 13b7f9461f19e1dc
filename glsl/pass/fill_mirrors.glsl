#version 330 core
// The mirror spheres that a scene defines, one in each texel. The host reads them to find the pixels that may hold the sun's image.
#include "scene.glsl"
#include <inputs>
#include <scene>
#include "light/lambert.glsl"
#include <spheres>

layout(location = 0) out vec4 fill_mirror;

void main() {
    int i = int(gl_FragCoord.x);
    fill_mirror = i < MIRROR_SPHERES ? mirror_sphere(i) : vec4(0.0);
}
