#version 330 core
// One progressive pass: a group of samples for each pixel, added to the film. Row 0 of the target is the picture's top.
#include "scene.glsl"
#include <sequence>
#include <sky>
#include <inputs>
#include <scene>
#include <spheres>
#include <bounds>
#include <mist>
#include <materials>
#include <sun>
#include <sun-image>
#include <emission>
#include <light>
#include "math/finite.glsl"
#include "pass/camera.glsl"
#include "pass/film.glsl"
#include <scatter>
#include <search>
#include <chance>
#include <rejects>

uniform uint group_samples;
uniform uint seed;
uniform int max_hits;

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    vec4 group = vec4(0.0);
    uint first_sample = film_samples();
    uint i = 0u;
    do {
        Sequence sequence = sequence_start(pixel.x, pixel.y, first_sample + i, seed);
        Ray ray = camera_ray(vec2(pixel), sequence_pair(sequence));
        vec3 radiance = path_radiance(ray, max_hits, sequence);
        bool finite = is_finite(radiance);
        bool counts = finite && !loops_ended();
        film_reject(radiance, finite, counts);
        vec4 counted = vec4(radiance, 1.0);
        group += counts ? counted : vec4(0.0);
        i += 1u;
    } while (i < group_samples);
    group += vec4(sun_image_sum() * (group.a / float(group_samples)), 0.0);
    film_scatter(group);
    film_search();
    film_chance();
    film_rejects(film_add(group, float(group_samples) - group.a), group.a);
}
