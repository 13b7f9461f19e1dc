#version 330 core
// Looks for values that no surface can have, in what the scene itself reports along a few paths for each pixel of a coarse picture. Pictures are made
// with values that are put right (light/surface.glsl), so the host says it. It also looks for surfaces whose coordinates are large beside their
// distance from the camera, because float has too few digits there.
#include "scene.glsl"
#include <sequence>
#include <inputs>
#include <scene>
#include <spheres>
#include <mist>
#include <materials>
#include "light/lambert.glsl"
#include "light/surface.glsl"
#include "pass/camera.glsl"
#include "pass/sun.glsl"

uniform uint check_paths;
uniform int check_hits;
uniform uint seed;

// The worst values, and the objects that have them, as src/render/check.c lists them: the normal's squared length, the least and the largest albedo,
// and the ratio of coordinates to the distance from the camera at a camera ray's hit; the least and the largest roughness, the least index of
// refraction, and by how much the density of mist leaves its range. A pixel that meets nothing reports the values of a good surface.
layout(location = 0) out vec4 check_values;
layout(location = 1) out vec4 check_objects;
layout(location = 2) out vec4 check_values_more;
layout(location = 3) out vec4 check_objects_more;
// Of the ways through mist: how many were followed; the light that comes through them too much, over all; and on how many of them it does.
layout(location = 4) out vec4 check_tracks;

void check_hit(Hit reported, Material material, bool first) {
    float object = float(reported.object);
    float squared = dot(reported.normal, reported.normal);
    float low = min(material.color.x, min(material.color.y, material.color.z));
    float high = max(material.color.x, max(material.color.y, material.color.z));
    bool reflects = !material_emits(material);
    vec3 size = abs(reported.position);
    float ratio = max(max(size.x, size.y), size.z) / reported.t;
    bvec4 worse = bvec4(max(squared, 1.0 / squared) > max(check_values.x, 1.0 / check_values.x), reflects && low < check_values.y,
                        reflects && high > check_values.z, first && ratio > check_values.w);
    check_values = mix(check_values, vec4(squared, low, high, ratio), worse);
    check_objects = mix(check_objects, vec4(object), worse);
    vec4 more = vec4(material.roughness, material.roughness, material.ior, 0.0);
    bvec4 more_worse = bvec4(more.x < check_values_more.x, more.y > check_values_more.y, more.z < check_values_more.z, false);
    check_values_more = mix(check_values_more, more, more_worse);
    check_objects_more = mix(check_objects_more, vec4(object), more_worse);
}

void check_way(Ray ray, float distance) {
    bool there = mist_way(ray, distance).depth > 0.0;
    float excess = mist_overrun(ray, distance);
    check_tracks += there ? vec4(1.0, excess, excess > 0.0 ? 1.0 : 0.0, 0.0) : vec4(0.0);
}

// The mist on a ray of the path, and on the ray to the sun from its end.
void check_mist(Ray ray, Hit reported, INOUT(Sequence) sequence) {
    mist_begin(sequence_pair(sequence));
    check_values_more.w = max(check_values_more.w, mist_excess(ray, reported.t, sequence_pair(sequence).x));
    check_way(ray, reported.t);
    if (reported.t < INFINITY) {
        Ray sunward = ray_from(surface_faced(reported, ray), sun_direction);
        check_way(sunward, surface_reported(sunward).t);
    }
}

void main() {
    check_values = vec4(1.0, 0.0, 1.0, 0.0);
    check_objects = vec4(0.0);
    check_values_more = vec4(0.0, 1.0, 1.0, 0.0);
    check_objects_more = vec4(0.0);
    check_tracks = vec4(0.0);
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint i = 0u;
    do {
        Sequence sequence = sequence_start(pixel.x, pixel.y, i, seed);
        Ray ray = camera_ray(vec2(pixel), sequence_pair(sequence));
        int hits = 0;
        bool alive = true;
        do {
            Hit reported = surface_reported(ray);
            alive = reported.t < INFINITY;
            if (mist_here()) check_mist(ray, reported, sequence);
            if (alive) {
                Hit hit = surface_faced(reported, ray);
                vec2 u = sequence_pair(sequence);
                vec2 v = sequence_pair(sequence);
                check_hit(reported, scene_material(hit), hits == 0);
                Bounce bounce = material_sample(surface_material(hit), hit.normal, ray.direction, u, v);
                ray = ray_from(hit, bounce.direction);
                alive = max(bounce.weight.x, max(bounce.weight.y, bounce.weight.z)) > 0.0;
            }
            hits += 1;
        } while (alive && hits < check_hits);
        i += 1u;
    } while (i < check_paths);
}
