#version 330 core
// Looks for surfaces that throw the sun's light on others, along a few paths for each pixel of a coarse picture. Each pixel writes the position of one of
// those that its paths met, in the coordinates of sun/aim.glsl, and 1; or zeros if they met none.
#include "scene.glsl"
#include <sequence>
#include <inputs>
#include <scene>
#include <spheres>
#include <mist>
#include <materials>
#include "light/lambert.glsl"
#include "light/surface.glsl"
#include "pass/aim.glsl"
#include "pass/camera.glsl"
#include "pass/sun_disk.glsl"
#include "sun/aim.glsl"
#include "sun/balance.glsl"
#include <mirrors>
#include <planes>

uniform uint seed;
uniform uint thrower_paths;
uniform int thrower_hits;

layout(location = 0) out vec4 thrower_found;

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    vec3 found = vec3(0.0);
    float count = 0.0;
    uint i = 0u;
    do {
        Sequence sequence = sequence_start(pixel.x, pixel.y, i, seed ^ 0x51ed270bu);
        Ray ray = camera_ray(vec2(pixel), sequence_pair(sequence));
        int hits = 0;
        bool alive = true;
        do {
            Hit hit = surface_hit(ray);
            alive = hit.t < INFINITY;
            if (alive) {
                vec2 u = sequence_pair(sequence);
                vec2 v = sequence_pair(sequence);
                Material material = surface_material(hit);
                Bounce bounce = material_sample(material, hit.normal, ray.direction, u, v);
                bool named = mirrors_know(hit, material, ray.direction) || planes_know(hit, material);
                alive = max(bounce.weight.x, max(bounce.weight.y, bounce.weight.z)) > 0.0;
                bool throws = alive && (bounce.pdf > 0.0 ? balance_counts(material) : !named);
                count += throws ? 1.0 : 0.0;
                if (throws && v.y * count < 1.0) found = hit.position;
                ray = ray_from(hit, bounce.direction);
            }
            hits += 1;
        } while (alive && hits < thrower_hits);
        i += 1u;
    } while (i < thrower_paths);
    thrower_found = vec4(aim_coordinates(found), min(count, 1.0));
}
