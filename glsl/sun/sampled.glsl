// --sun-disk sampled: every hit sends rays to the disk, directly and by way of the mirror spheres and the flat mirrors that the
// scene names. Sunlight that these rays cannot find, such as by way of a sphere and another mirror, is left to chance. How much
// there may be of it is counted.
#include "light/through.glsl"
#include "sun/ask.glsl"
#include "sun/count.glsl"
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

// The next value of SunState.found.
int sun_found(int found, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    if (bounce.pdf > 0.0) return SUN_SOUGHT;
    if (found <= SUN_PICTURED && mirrors_know(hit, material, incoming)) return SUN_REFLECTED;
    bool plane = planes_know(hit, material);
    if ((found == SUN_PICTURED || found == SUN_SHOWN) && plane) return SUN_SHOWN;
    int reflections = found == SUN_SOUGHT ? 0 : found >= SUN_PLANES ? found - SUN_PLANES + 1 : PLANE_CHAIN;
    return reflections < PLANE_CHAIN && plane ? SUN_PLANES + reflections : SUN_CHANCE;
}

// A glossy surface leaves sunlight to chance too. Its ray to the sun brings much light, but only if the path came to one of the few
// points from which the sun is in the lobe. After a surface that scatters widely, a path gets to such a point only by luck.
SunState sun_after_bounce(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    SunState next = state;
    next.found = sun_found(state.found, hit, material, incoming, bounce);
    if (bounce.pdf > 0.0) {
        float throws = material_throws(material);
        next.chance = state.scattered ? throws : 0.0;
        next.scattered = state.scattered || throws < 1.0;
    } else {
        next.chance = next.found == SUN_CHANCE ? 1.0 : state.chance;
    }
    next.thrower = bounce.pdf > 0.0 || next.found == SUN_CHANCE ? material.kind : state.thrower;
    return next;
}

vec3 sun_escaped(SunState state, vec3 direction) {
    return state.found == SUN_CHANCE || state.found == SUN_SHOWN ? sun_radiance(direction) : vec3(0.0);
}

// The number of paths that find the sun says nothing about light that few paths can find. So the sun is spread over a wide cone
// with the same irradiance. The light that the paths would bring from there is about the light that is left to chance, and to count
// it takes no luck.
void sun_count(SunState state, vec3 throughput, vec3 direction, vec3 disk) {
    bool counts = state.chance > 0.0;
    bool near = counts && sun_is_near(direction);
    chance_paths += counts ? 1.0 : 0.0;
    chance_near += near ? state.chance * throughput : vec3(0.0);
    chance_found += counts ? throughput * disk : vec3(0.0);
    chance_materials |= near ? 1 << min(state.thrower, CHANCE_MATERIALS - 1) : 0;
}
