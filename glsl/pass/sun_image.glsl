#version 330 core
// The image of the sun's disk in the picture: seen directly, and in the mirror spheres that the scene names. The image is about as
// large as a pixel or smaller, and 1e5 times as bright as all else, so finding it must not depend on luck. This pass is drawn
// before each group of samples, on the few pixels where the image may be, and writes the image's radiance summed over the group.
#include "scene.glsl"
#include <sequence>
#include <inputs>
#include <scene>
#include <spheres>
#include <mist>
#include <materials>
#include "light/lambert.glsl"
#include "light/through.glsl"
#include "math/finite.glsl"
#include "pass/camera.glsl"
#include "pass/film_samples.glsl"
#include "pass/sun_disk.glsl"
#include <mirrors-image>

uniform uint group_samples;
uniform uint seed;

// The mean radiance that the unblocked disk gives each pixel of a rectangle.
uniform sampler2D sun_image_cover;
// The rectangle's first pixel.
uniform vec3 sun_image_corner;
// A point well inside of the visible disk, in pixels.
uniform vec3 sun_image_heart;

// The disk seen directly. The light that the unblocked disk gives the pixel is known exactly. One point of the pixel, the nearest
// to the disk's heart, is a guess of how much of it the scene lets through. Where a sample contradicts the guess, the difference is
// added. The result is unbiased, and it has no noise wherever the pixel's part of the disk is all open or all blocked.
vec3 sun_image_direct(vec2 pixel, vec2 u) {
    ivec2 at = ivec2(pixel) - ivec2(sun_image_corner.xy);
    ivec2 size = textureSize(sun_image_cover, 0);
    bool covered = at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
    vec3 cover = covered ? texelFetch(sun_image_cover, clamp(at, ivec2(0), size - 1), 0).rgb : vec3(0.0);
    vec2 nearest = clamp(vec2(sun_image_heart.x, sun_image_heart.y) - pixel, vec2(0.0), vec2(1.0));
    vec3 guess = covered ? light_arriving(camera_ray(pixel, nearest)) : vec3(0.0);
    Ray ray = camera_ray(pixel, u);
    vec3 seen = light_arriving(ray);
    return guess * cover + (seen - guess) * sun_radiance(ray.direction);
}

layout(location = 0) out vec4 sun_image_group;

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint first_sample = film_samples();
    vec3 group = vec3(0.0);
    uint i = 0u;
    do {
        Sequence sequence = sequence_start(pixel.x, pixel.y, first_sample + i, seed ^ 0x5bd1e995u);
        vec2 u = sequence_pair(sequence);
        mist_begin(u);
        vec3 image = sun_image_direct(vec2(pixel), u) + mirrors_image(vec2(pixel), first_sample + i, seed);
        group += is_finite(image) ? image : vec3(0.0);
        i += 1u;
    } while (i < group_samples);
    sun_image_group = vec4(group, 0.0);
}
