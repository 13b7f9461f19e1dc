// A part of a path, from one hit to the next: the surface that the ray meets, and the mist before it.
#include "light/surface.glsl"
#include "light/through.glsl"
#include "light/walk.glsl"
#include "mist/ask.glsl"
#include "sun/ask.glsl"

struct Stretch {
    // The surface that the ray meets, whether the path comes to it or not.
    Hit surface;
    // Where the path goes on: on the surface, or in the mist before it.
    Hit hit;
    bool in_mist;
    // The mist before the surface.
    MistWay way;
    // The place in it that stands for all of it.
    MistPoint point;
    // The light that comes from the path's hit, over the probability that this is the hit.
    vec3 weight;
};

// w draws the place of the path's next hit, and the place that stands for the mist.
Stretch stretch_of(Path path, vec2 w) {
    Ray ray = path.ray;
    Hit surface = surface_hit(ray);
    Stretch stretch = Stretch(surface, surface, false, mist_way(ray, surface.t), MistPoint(0.0, vec3(0.0)), vec3(1.0));
    if (mist_here()) {
        MistEvent event = mist_event(stretch.way, path.throughput, w.x);
        stretch.in_mist = event.t < INFINITY;
        stretch.weight = event.weight;
        if (stretch.in_mist) stretch.hit = mist_hit(ray, event.t);
        stretch.point = mist_point(stretch.way, path.throughput, w.y);
    }
    return stretch;
}

// What is there where the path goes on.
Material stretch_material(Stretch stretch) {
    Material material = surface_material(stretch.surface);
    if (stretch.in_mist) material = mist_material(stretch.hit.position);
    return material;
}

// The sunlight that the mist scatters toward the ray's origin, for light that comes by way of at most `mirrors` mirrors.
vec3 stretch_sun(Stretch stretch, Path path, int mirrors, INOUT(Sequence) sequence) {
    vec3 scattered = vec3(0.0);
    vec3 weight = stretch.point.weight;
    Hit place = mist_hit(path.ray, stretch.point.t);
    if (mist_is_air()) {
        scattered = weight * air_sunlight(place.position, path.ray.direction);
        if (max(scattered.x, max(scattered.y, scattered.z)) > 0.0) scattered *= light_arriving(ray_from(place, air_sun_direction()));
    } else if (max(weight.x, max(weight.y, weight.z)) > 0.0) {
        Material material = mist_material(place.position);
        scattered = weight * sun_reflected(path.sun, place, material, path.ray.direction, mirrors, sequence);
    }
    return scattered;
}

// A control variate of mean 0 for a bounce in the mist: the light of the open sky is known there, and the bounce takes off what it brings of it. So a bounce that leaves
// the scene brings the known light in place of what the sky happens to be in its direction.
//
// It is weighed by how much of the sky is likely to arrive. That must not depend on the bounce, and a wrong weight costs noise alone. If no surface stands on the
// path's own ray, most of what is turned forward arrives but for the mist behind. If one does, the sky is counted on only where it is said to be open.
vec3 stretch_sky(Stretch stretch, Material material, vec3 incoming, Bounce bounce) {
    bool open = stretch.surface.t >= INFINITY;
    vec3 taken = vec3(0.0);
    if (open || mist_in_open()) {
        vec3 toward = open ? incoming : vec3(0.0, 1.0, 0.0);
        vec3 arriving = light_through(Ray(stretch.hit.position, toward), INFINITY);
        taken = mist_sky_share() * arriving * (material.color * mist_sky(incoming) - bounce.weight * sky_radiance(bounce.direction));
    }
    return taken;
}

// The sunlight that the surface reflects and the mist lets through. `material` is that of the path's hit.
vec3 stretch_surface_sun(Stretch stretch, Path path, Material material, int mirrors, INOUT(Sequence) sequence) {
    vec3 reflected = vec3(0.0);
    if (!mist_here()) {
        reflected = sun_reflected(path.sun, stretch.surface, material, path.ray.direction, mirrors, sequence);
    } else if (stretch.surface.t < INFINITY) {
        Material there = surface_material(stretch.surface);
        reflected = mist_kept(stretch.way) * sun_reflected(path.sun, stretch.surface, there, path.ray.direction, mirrors, sequence);
    }
    return reflected;
}
