// No light is traced from the sun: paths count all of it.
#include "sun/share.glsl"

float sun_share(float traced, Ray ray) {
    return 1.0;
}

float sun_share_reflected(float traced, Hit hit, Material material, vec3 incoming, vec3 toward) {
    return 1.0;
}

float sun_traced(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    return 0.0;
}
