// --sun-disk sampled: every hit sends rays to the disk, directly and by way of the mirror spheres and the flat mirrors that the
// scene names. Sunlight that these rays cannot find, such as by way of a sphere and another mirror, is left to chance. How much
// there may be of it is counted.
#include "light/through.glsl"
#include "sun/ask.glsl"
#include "sun/disk.glsl"
#include "sun/near.glsl"
#include "sun/share.glsl"
#include <mirrors>
#include <planes>

// Whether the last ray to the disk arrived.
bool sun_arrived = false;

bool sun_shines() {
    return true;
}

vec3 sun_reflected(SunState state, Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence) {
    vec2 u = sequence_pair(sequence);
    vec3 toward = sun_point(u);
    vec3 irradiance = sun_solid_angle() * sun_radiance(toward);
    vec3 value = material_value(material, hit.normal, incoming, toward);
    vec3 reflected = vec3(0.0);
    if (max(value.x, max(value.y, value.z)) > 0.0) {
        reflected = value * irradiance * light_arriving(ray_from(hit, toward));
    }
    sun_arrived = max(reflected.x, max(reflected.y, reflected.z)) > 0.0;
    if (sun_arrived) reflected *= sun_share_reflected(state.traced, hit, material, incoming, toward);
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
// points from which the sun is in the lobe. After a surface that scatters widely, a path gets to such a point only by luck. It has
// found the light if the lobe is about as dense toward the sun as toward the bounce.
SunState sun_after_bounce(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    SunState next = state;
    next.found = sun_found(state.found, hit, material, incoming, bounce);
    if (bounce.pdf > 0.0) {
        float throws = material_throws(material);
        bool lit = state.scattered && throws > 0.0 && sun_arrived;
        if (lit && material_pdf(material, hit.normal, incoming, sun_middle()) > 0.25 * bounce.pdf) {
            chance_met |= chance_bit(material.kind);
        }
        next.chance = state.scattered ? throws : 0.0;
        next.peak = sun_peak(bounce.pdf);
        next.scattered = state.scattered || throws < 1.0;
    } else if (next.found == SUN_CHANCE) {
        next.chance = 1.0;
        next.peak = 1.0 / sun_solid_angle();
    }
    next.traced = sun_traced(state, hit, material, incoming, bounce);
    next.thrower = bounce.pdf > 0.0 || next.found == SUN_CHANCE ? material.kind : state.thrower;
    return next;
}

vec3 sun_escaped(SunState state, vec3 direction) {
    return state.found == SUN_CHANCE || state.found == SUN_SHOWN ? sun_radiance(direction) : vec3(0.0);
}
