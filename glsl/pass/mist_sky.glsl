// The light of the open sky that mist scatters, from a table.
#include "mist/ask.glsl"
#include "mist/sky_table.glsl"
#include "pass/sun.glsl"
// The constant MIST_IN_OPEN.
#include <mist-open>

uniform sampler2D scattered_table;
uniform vec3 scattered_size;
uniform float scattered_share;

bool mist_knows_sky() {
    return true;
}

bool mist_in_open() {
    return MIST_IN_OPEN;
}

float mist_sky_share() {
    return scattered_share;
}

vec3 mist_sky(vec3 incoming) {
    vec2 size = vec2(scattered_size.x, scattered_size.y);
    return textureLod(scattered_table, (scattered_position(incoming, sun_level) * (size - 1.0) + 0.5) / size, 0.0).rgb;
}
