#version 330 core
// Traces light paths from the sun's disk, one in each texel. A path bounces among the surfaces. At each hit that scatters, except the first one that the
// sun reaches straight, it is joined to the camera, and one of these joints is written: the light that all of them bring, and the pixel. Each counts
// the share that paths from the camera leave to it (sun/share.glsl).
#include "scene.glsl"
#include <sequence>
#include <inputs>
#include <scene>
#include <spheres>
#include <mist>
#include <materials>
#include "light/lambert.glsl"
#include "light/roulette.glsl"
#include "light/through.glsl"
#include "pass/aim.glsl"
#include "pass/camera.glsl"
#include "pass/light_point.glsl"
#include "pass/sun_disk.glsl"
#include "sun/aim.glsl"
#include "sun/balance.glsl"
#include <mirrors>
#include <planes>

uniform uint seed;
uniform int max_hits;
// The number of the first texel's path in its lower and its upper 32 bits, and the number of texels in a row.
uniform uint photon_first;
uniform uint photon_lap;
uniform uint photon_columns;

// The joint's light for 1 path, and its pixel; and the place of the path on the plane of sun/aim.glsl, with the brightness of its light in the last
// component.
layout(location = 0) out vec4 photon_point;
layout(location = 1) out vec4 photon_start;

struct Photon {
    Ray ray;
    // Radiance times square metres times steradians: the light that the path carries, over its density.
    vec3 power;
    // How likely the path is, over how likely paths from the camera are to take it: R of sun/share.glsl so far.
    float traced;
    int hits;
    // The number of mirrors and glass surfaces before the first hit that scatters, and whether all of them are mirrors by way of which rays to the sun are sent.
    int chain;
    bool known;
    // Whether the path has been scattered.
    bool scattered;
    // The index of refraction of the substance around the path. Radiances in it are in units of the index squared, as those of paths from the camera are.
    float index;
};

// The joint so far, and the brightness of all joints.
vec2 joint_pixel = vec2(0.0);
vec3 joint_light = vec3(0.0);
float joint_sum = 0.0;

float photon_brightness(vec3 light) {
    return (light.x + light.y + light.z) / 3.0;
}

// Joins a hit to the camera. `direct` says whether the light came there straight from the sun.
void photon_join(Photon photon, Hit hit, Material material, bool direct, float u) {
    vec3 to_eye = camera_eye - hit.position;
    float distance = length(to_eye);
    to_eye /= distance;
    float forward = -dot(to_eye, camera_forward);
    float cos_eye = dot(hit.normal, to_eye);
    float cos_in = -dot(hit.normal, photon.ray.direction);
    vec2 at = -vec2(dot(to_eye, camera_right) / dot(camera_right, camera_right), -dot(to_eye, camera_up) / dot(camera_up, camera_up)) / max(forward, 1.0e-6);
    vec2 pixel = 0.5 * (at + 1.0) * vec2(picture_size.x, picture_size.y);
    bool seen = forward > 1.0e-6 && cos_eye > 1.0e-6 && cos_in > 1.0e-6 && pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < picture_size.x && pixel.y < picture_size.y;
    vec3 value = seen ? material_value(material, hit.normal, -to_eye, -photon.ray.direction) : vec3(0.0);
    if (max(value.x, max(value.y, value.z)) > 0.0) {
        Ray ray = ray_from(hit, to_eye);
        Hit before = surface_hit(ray);
        float solid_angle = camera_pixel_solid_angle(-to_eye);
        float traced = photon.traced * distance * distance * solid_angle * balance_first(hit.normal, material, -to_eye, -photon.ray.direction);
        float share = 1.0 / (1.0 + 1.0 / max(aim_paths * traced, 1.0e-30));
        vec3 light = photon.power * value * (share * cos_eye / (cos_in * distance * distance * solid_angle * photon.index * photon.index));
        light *= before.t < 0.9999 * distance ? vec3(0.0) : light_through(ray, distance);
        float brightness = photon_brightness(light);
        joint_sum += brightness;
        if (u * joint_sum < brightness) {
            joint_pixel = pixel;
            joint_light = light / brightness;
        }
    }
}

// The path after a mirror or glass.
void photon_turn(INOUT(Photon) photon, Hit hit, Material material, Bounce bounce) {
    if (!photon.scattered) {
        photon.chain += 1;
        bool sphere = photon.chain == 1 && mirrors_know(hit, material, photon.ray.direction);
        bool planes = photon.chain <= PLANE_CHAIN && (photon.chain == 1 || photon.known) && planes_know(hit, material);
        photon.known = sphere || planes;
    }
    photon.index *= dot(bounce.direction, hit.normal) < 0.0 ? material.ior : 1.0;
    photon.power *= bounce.weight;
}

// The path after a hit that scatters. Returns the weight, f cos / density for light that goes this way, from the value for light that goes to the camera.
vec3 photon_scatter(INOUT(Photon) photon, Hit hit, Material material, Bounce bounce, bool direct) {
    float cos_in = max(-dot(hit.normal, photon.ray.direction), 1.0e-6);
    float cos_out = max(dot(hit.normal, bounce.direction), 0.0);
    vec3 value = material_value(material, hit.normal, -bounce.direction, -photon.ray.direction);
    vec3 weight = value * (cos_out / (cos_in * bounce.pdf));
    photon.power *= weight;
    photon.traced *= direct ? balance_end(hit.normal, material, -bounce.direction, -photon.ray.direction)
                            : balance_between(hit.normal, material, -bounce.direction, -photon.ray.direction);
    photon.scattered = true;
    return weight;
}

// One hit. Returns whether the path goes on.
bool photon_hit(INOUT(Photon) photon, INOUT(Sequence) sequence) {
    Hit hit = surface_hit(photon.ray);
    bool alive = hit.t < INFINITY && photon.hits < max_hits;
    photon.hits += 1;
    if (alive) {
        vec2 u = sequence_pair(sequence);
        vec2 v = sequence_pair(sequence);
        float survival = photon.hits < ROULETTE_HITS ? 1.0 : ROULETTE_SURVIVAL;
        Material material = surface_material(hit);
        Bounce bounce = material_sample(material, hit.normal, photon.ray.direction, u, v);
        photon.power *= light_through(photon.ray, hit.t);
        if (bounce.pdf > 0.0) {
            bool direct = photon.chain == 0 && !photon.scattered;
            if (!photon.scattered) {
                alive = direct ? balance_counts(material) : !photon.known;
                photon.traced /= direct ? 1.0 : sun_solid_angle();
            }
            if (alive && !direct) photon_join(photon, hit, material, direct, sequence_pair(sequence).x);
            vec3 weight = photon_scatter(photon, hit, material, bounce, direct);
            survival = min(max(weight.x, max(weight.y, weight.z)), ROULETTE_SURVIVAL);
        } else {
            photon_turn(photon, hit, material, bounce);
        }
        photon.ray = ray_from(hit, bounce.direction);
        // Roulette keeps the power of the light that goes on: later joints bring less, so there may be fewer of them.
        alive = alive && !(v.y >= survival) && max(photon.power.x, max(photon.power.y, photon.power.z)) > 0.0;
        photon.power /= max(survival, 1.0e-6);
    }
    return alive;
}

void main() {
    uint index = photon_first + uint(gl_FragCoord.y) * photon_columns + uint(gl_FragCoord.x);
    Sequence sequence = sequence_start(0u, 0u, index, seed ^ (0x2c1b3c6du + photon_lap));
    vec2 u = sequence_pair(sequence);
    vec3 toward = sun_point(sequence_pair(sequence));
    vec2 at = aim_sample(u, sequence_pair(sequence).x);
    float density = aim_density_at(at) / dot(toward, sun_middle());
    Ray away = Ray(aim_begin(at, toward), toward);
    Photon photon = Photon(Ray(away.origin, -toward), vec3(0.0), density, 0, 0, false, false, 1.0);
    if (density > 0.0) photon.power = sun_radiance(toward) * light_arriving(away) * (sun_solid_angle() / density);
    bool alive = max(photon.power.x, max(photon.power.y, photon.power.z)) > 0.0;
    while (alive) alive = photon_hit(photon, sequence);
    photon_point = vec4(joint_sum * joint_light, light_point_pixel(joint_pixel));
    photon_start = vec4(at, 0.0, joint_sum);
}
