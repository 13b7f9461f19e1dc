// A scene that does not say where its emitters are: the bounces find them or do not.
#include "emission/met.glsl"

vec3 emission_direction(Hit hit, INOUT(Sequence) sequence) {
    return hit.normal;
}

vec3 emission_reflected(Hit hit, Material material, vec3 incoming, vec3 direction, float bounce_pdf) {
    return vec3(0.0);
}

float emission_share(Hit hit, Bounce bounce) {
    return 1.0;
}
