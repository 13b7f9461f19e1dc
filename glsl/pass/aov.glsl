#version 330 core
// The arbitrary output variables of a picture: albedo, normal and depth at the first hits of the camera rays, which are surfaces, and what the mist before
// them lets through. One draw adds a group
// of samples for each pixel to the sums so far.
#include "scene.glsl"
#include <sequence>
#include <inputs>
#include <scene>
#include <spheres>
#include "light/lambert.glsl"
#include "light/surface.glsl"
#include <mist>
#include "math/finite.glsl"
#include "pass/camera.glsl"

uniform uint first_sample;
uniform uint group_samples;
uniform uint seed;
// Alpha holds the number of samples that hit something.
uniform sampler2D aov_albedo;
// Alpha holds the sum of the depths.
uniform sampler2D aov_normal;
// Red holds the sum of the transmittances, to the hit or through all of the mist.
uniform sampler2D aov_mist;

layout(location = 0) out vec4 aov_albedo_next;
layout(location = 1) out vec4 aov_normal_next;
layout(location = 2) out vec4 aov_mist_next;

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    vec4 albedo = vec4(0.0);
    vec4 normal = vec4(0.0);
    float kept = 0.0;
    uint i = 0u;
    do {
        Sequence sequence = sequence_start(pixel.x, pixel.y, first_sample + i, seed);
        vec2 place = sequence_pair(sequence);
        Ray ray = camera_ray(vec2(pixel), place);
        Hit hit = surface_hit(ray);
        mist_begin(place);
        // The luminance, written so that grey stays the same to the bit.
        vec3 through = mist_kept(mist_way(ray, hit.t));
        kept += through.y + 0.2126 * (through.x - through.y) + 0.0722 * (through.z - through.y);
        if (hit.t < INFINITY) {
            vec3 color = scene_material(hit).color;
            albedo += vec4(is_finite(color) ? clamp(color, 0.0, 1.0) : vec3(0.0), 1.0);
            normal += vec4(is_finite(hit.normal) ? hit.normal : vec3(0.0), hit.t * dot(ray.direction, camera_forward));
        }
        i += 1u;
    } while (i < group_samples);
    aov_albedo_next = texelFetch(aov_albedo, ivec2(pixel), 0) + albedo;
    aov_normal_next = texelFetch(aov_normal, ivec2(pixel), 0) + normal;
    aov_mist_next = texelFetch(aov_mist, ivec2(pixel), 0) + vec4(kept, 0.0, 0.0, 0.0);
}
