// For mist that is the scene's own, and for scenes without mist.
#include "mist/ask.glsl"

bool mist_is_air() {
    return false;
}

vec3 air_sunlight(vec3 position, vec3 incoming) {
    return vec3(0.0);
}

vec3 air_sun_direction() {
    return vec3(0.0, 1.0, 0.0);
}
