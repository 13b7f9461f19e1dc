// --sun sampled: every hit looks for the disk itself, straight and by way of the mirror spheres and the flat mirrors that the scene
// names. What those cannot find, such as by way of a sphere and another mirror, is left to chance.
#include "light/through.glsl"
#include "sun/ask.glsl"
#include "sun/disk.glsl"
#include <mirrors>
#include <planes>

vec3 sun_reflected(Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence) {
    vec2 u = sequence_pair(sequence);
    vec3 toward = sun_point(u);
    vec3 irradiance = sun_solid_angle() * sun_radiance(toward);
    vec3 value = material_value(material, hit.normal, incoming, toward);
    vec3 reflected = vec3(0.0);
    if (max(value.x, max(value.y, value.z)) > 0.0) {
        reflected = value * irradiance * light_arriving(ray_from(hit, toward));
    }
    if (mirrors > 0) {
        reflected += mirrors_reflect(hit, material, incoming, toward, irradiance, sequence);
        reflected += planes_reflect(hit, material, incoming, toward, mirrors, sequence);
    }
    return reflected;
}

int sun_after_bounce(int state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    if (bounce.pdf > 0.0) return SUN_SOUGHT;
    if (state <= SUN_PICTURED && mirrors_know(hit, material, incoming)) return SUN_REFLECTED;
    int reflections = state == SUN_SOUGHT ? 0 : state >= SUN_PLANES ? state - SUN_PLANES + 1 : PLANE_CHAIN;
    return reflections < PLANE_CHAIN && planes_know(hit, material) ? SUN_PLANES + reflections : SUN_CHANCE;
}

vec3 sun_escaped(int state, vec3 direction) {
    return state == SUN_CHANCE ? sun_radiance(direction) : vec3(0.0);
}
