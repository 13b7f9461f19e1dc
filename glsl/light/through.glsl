// What light keeps on its way between two points. Every ray that looks for light from a hit goes through these two functions: toward
// the sun's disk, straight or by way of mirrors, and toward lamps.
#include "light/surface.glsl"
#include "mist/ask.glsl"

// What light keeps along the first `distance` metres of a ray on which no surface stands.
vec3 light_through(Ray ray, float distance) {
    return mist_kept(mist_way(ray, distance));
}

// What light from beyond the scene keeps until it reaches the origin of the ray; 0 where a surface blocks it.
vec3 light_arriving(Ray ray) {
    return surface_hit(ray).t < INFINITY ? vec3(0.0) : light_through(ray, INFINITY);
}
