// No rays are sent toward emitters. Only the bounces find them.
#include "emission/ask.glsl"

bool emission_sought() {
    return false;
}

vec3 emission_direction(Hit hit, INOUT(Sequence) sequence) {
    return hit.normal;
}

vec3 emission_reflected(Hit hit, Material material, vec3 incoming, vec3 direction, float bounce_pdf) {
    return vec3(0.0);
}

float emission_share(Hit hit, Bounce bounce) {
    return 1.0;
}
