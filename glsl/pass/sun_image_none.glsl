// No image of the sun's disk near this pixel.
#include "scene.glsl"

vec3 sun_image(uvec2 pixel, uint index, uint seed) {
    return vec3(0.0);
}
