// The crater's picture, pixel by pixel, with the sequence and the light that the case included before this file.
// Inputs: (hover, albedo of the even squares, of the odd ones, samples a pixel), (sun direction, hits at most).
#include "../../scenes/crater.glsl"
#include <materials>

const float SIDE = 32.0; // of the picture, in pixels

void prepare_sky(vec3 sun);

// The crater's own camera: 90 degrees, from (0, 2, -4) toward the origin.
Ray camera_ray(vec2 at) {
    vec3 forward = normalize(vec3(0.0, -2.0, 4.0));
    vec3 right = vec3(-1.0, 0.0, 0.0);
    vec2 plane = 2.0 * at / SIDE - 1.0;
    return Ray(vec3(0.0, 2.0, -4.0), normalize(forward + plane.x * right - plane.y * cross(right, forward)));
}

vec4 evaluate(vec2 texel) {
    vec4 scene = texelFetch(inputs, ivec2(0, 0), 0);
    vec4 light = texelFetch(inputs, ivec2(1, 0), 0);
    ball = true;
    hover = scene.x;
    even_albedo = scene.y;
    odd_albedo = scene.z;
    prepare_sky(vec3(light));
    vec3 sum = vec3(0.0);
    int i = 0;
    do {
        Sequence sequence = sequence_start(uint(texel.x), uint(texel.y), uint(i), 1u);
        Ray ray = camera_ray(texel + sequence_pair(sequence));
        sum += path_radiance(ray, int(light.w), sequence);
        i += 1;
    } while (i < int(scene.w));
    return vec4(sum / scene.w, 1.0);
}
