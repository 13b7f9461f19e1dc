// How directions map to the table of the sky's light that mist scatters: across, the azimuth from the sun's on either side of it; along, the elevation.
#include "math/dialect.glsl"

vec2 scattered_position(vec3 direction, vec3 sun_level) {
    float along_sun = direction.x * sun_level.x + direction.z * sun_level.z;
    float aside = direction.x * sun_level.z - direction.z * sun_level.x;
    float level = sqrt(direction.x * direction.x + direction.z * direction.z);
    return vec2(atan(abs(aside), along_sun + (level < 1.0e-12 ? 1.0e-12 : 0.0)) / PI, 0.5 + atan(direction.y, level) / PI);
}

// The direction that lies there: toward the sun's azimuth, up, aside.
vec3 scattered_direction(vec2 position) {
    float elevation = PI * (position.y - 0.5);
    float azimuth = PI * position.x;
    return vec3(cos(elevation) * cos(azimuth), sin(elevation), cos(elevation) * sin(azimuth));
}
