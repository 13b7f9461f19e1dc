// The irradiance of the unblocked sky on all but level ground, as a function of the normal: how normals map to the unit square.
// Like the sky itself it is even about the sun's azimuth.
#include "math/dialect.glsl"

const float LEVEL_GROUND = 0.995; // least normal.y in the table: ground that slopes by up to 6 degrees

// Across: (1 - cos(azimuth from the sun)) / 2. Along: linear in the angle from straight up, where tilting counts.
vec2 irradiance_position(vec3 normal, vec3 sun_level) {
    float along_sun = normal.x * sun_level.x + normal.z * sun_level.z;
    float across = 0.5 - 0.5 * along_sun * inversesqrt(max(normal.x * normal.x + normal.z * normal.z, 1.0e-30));
    return vec2(across, sqrt(clamp((1.0 - normal.y) / (1.0 - LEVEL_GROUND), 0.0, 1.0)));
}

// The normal that lies there: toward the sun's azimuth, up, aside.
vec3 irradiance_normal(vec2 position) {
    float up = 1.0 - (1.0 - LEVEL_GROUND) * position.y * position.y;
    float level = sqrt(max(1.0 - up * up, 0.0));
    float toward_sun = 1.0 - 2.0 * position.x;
    return vec3(level * toward_sun, up, level * sqrt(max(1.0 - toward_sun * toward_sun, 0.0)));
}
