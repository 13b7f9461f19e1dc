#include "material/matte.glsl"
Material chalk(vec3 albedo) { return material_new(MATERIAL_CHALK, albedo); }
Bounce chalk_sample(Material m, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    return matte_sample(m, normal, incoming, u, v);
}
float chalk_pdf(Material m, vec3 normal, vec3 incoming, vec3 outgoing) {
    return matte_pdf(m, normal, incoming, outgoing);
}
vec3 chalk_value(Material m, vec3 normal, vec3 incoming, vec3 outgoing) {
    return matte_value(m, normal, incoming, outgoing);
}
