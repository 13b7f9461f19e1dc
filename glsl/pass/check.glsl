#version 330 core
// Looks for values that no surface can have, in what the scene itself reports along a few paths for each pixel of a coarse picture: normals
// that are not of unit length, and albedos below 0 or above 1. Pictures are made with values that are put right (light/surface.glsl), so the host
// says it. It also looks for surfaces whose coordinates are large beside their distance from the camera, because float has too few digits there.
#include "scene.glsl"
#include <sequence>
#include <inputs>
#include <scene>
#include <spheres>
#include <materials>
#include "light/lambert.glsl"
#include "light/surface.glsl"
#include "pass/camera.glsl"

uniform uint check_paths;
uniform int check_hits;
uniform uint seed;

// The squared length of the normal that is farthest from unit length, the least and the largest albedo, and the largest ratio of coordinates to the
// distance from the camera, at a camera ray's hit; and the objects that have them. A pixel that meets nothing reports the values of a good surface.
layout(location = 0) out vec4 check_values;
layout(location = 1) out vec4 check_objects;

void check_hit(Hit reported, Material material, bool first) {
    float object = float(reported.object);
    float squared = dot(reported.normal, reported.normal);
    float low = min(material.color.x, min(material.color.y, material.color.z));
    float high = max(material.color.x, max(material.color.y, material.color.z));
    bool emits = material_emits(material);
    vec3 size = abs(reported.position);
    float ratio = max(max(size.x, size.y), size.z) / reported.t;
    bool farther = max(squared, 1.0 / squared) > max(check_values.x, 1.0 / check_values.x);
    bool lower = !emits && low < check_values.y;
    bool higher = !emits && high > check_values.z;
    bool smaller = first && ratio > check_values.w;
    check_values = vec4(farther ? squared : check_values.x, lower ? low : check_values.y, higher ? high : check_values.z,
                        smaller ? ratio : check_values.w);
    check_objects = vec4(farther ? object : check_objects.x, lower ? object : check_objects.y, higher ? object : check_objects.z,
                         smaller ? object : check_objects.w);
}

void main() {
    check_values = vec4(1.0, 0.0, 1.0, 0.0);
    check_objects = vec4(0.0);
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
