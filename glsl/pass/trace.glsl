#version 330 core
// One progressive pass: a group of samples for each pixel, added to the film. Row 0 of the target is the picture's top.
#include "scene.glsl"
#include <sequence>
#include <sky>
#include <scene>
#include <bounds>
#include <materials>
#include <light>
#include "math/finite.glsl"
#include "pass/film.glsl"

uniform vec3 camera_eye;
uniform vec3 camera_forward; // unit length
uniform vec3 camera_right;   // to the picture's right edge at distance 1 ahead
uniform vec3 camera_up;      // to its top edge
uniform vec3 picture_size;   // width, height
uniform uint first_sample;
uniform uint group_samples;
uniform uint seed;
uniform int max_hits;

// Uniform in the pixel's area: a box filter.
Ray camera_ray(vec2 pixel, vec2 u) {
    vec2 at = 2.0 * (pixel + u) / vec2(picture_size.x, picture_size.y) - 1.0;
    return Ray(camera_eye, normalize(camera_forward + at.x * camera_right - at.y * camera_up));
}

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    vec4 group = vec4(0.0);
    uint i = 0u;
    do {
        Sequence sequence = sequence_start(pixel.x, pixel.y, first_sample + i, seed);
        Ray ray = camera_ray(vec2(pixel), sequence_pair(sequence));
        vec3 radiance = path_radiance(ray, max_hits, sequence);
        group += is_finite(radiance) ? vec4(radiance, 1.0) : vec4(0.0);
        i += 1u;
    } while (i < group_samples);
    film_add(group, float(group_samples) - group.a);
}
