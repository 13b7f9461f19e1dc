// For mist that does not know the sky's light before a path has found it.
#include "mist/ask.glsl"

bool mist_knows_sky() {
    return false;
}

bool mist_in_open() {
    return false;
}

float mist_sky_share() {
    return 0.0;
}

vec3 mist_sky(vec3 incoming) {
    return vec3(0.0);
}
