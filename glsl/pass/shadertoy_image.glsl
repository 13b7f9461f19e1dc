// The tab Image of a scene's program for Shadertoy: it shows the radiance of Buffer A as the program itself does in its window and in PNG files.
#include "pass/shown_tone.glsl"

void mainImage(out vec4 color, in vec2 at) {
    // Pixel (0, 0) of Buffer A holds no light, so that its neighbour is shown.
    ivec2 pixel = ivec2(at) == ivec2(0) ? ivec2(1, 0) : ivec2(at);
    vec3 light = texelFetch(iChannel0, pixel, 0).rgb;
    color = vec4(developed(light, uvec2(pixel.x, int(iResolution.y) - 1 - pixel.y)), 1.0);
}
