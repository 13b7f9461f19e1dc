#include "emission/ask.glsl"
#include "light/surface.glsl"

vec3 material_emitted(Material material, vec3 normal, vec3 incoming);

vec3 emission_met(Hit hit, vec3 incoming, float share) {
    vec3 emitted = vec3(0.0);
    if (hit.t < INFINITY) emitted = share * material_emitted(scene_material(hit), hit.normal, incoming);
    return emitted;
}
