// The table of the sky: how directions map to the unit square. The sums without phase functions depend on a direction's elevation and on its azimuth
// from the sun. They are even functions of this azimuth.
//
// Across the table runs (1 - cos(azimuth from the sun)) / 2. An even function stays smooth in it, and no arc tangent is needed.
//
// Along the table runs the fourth root of 1 - sqrt(1 - share). `share` is the sine of the elevation above the visible horizon, or below it, scaled to
// 1 at the zenith or the nadir. The inner root makes the coordinate linear in the angle from the zenith, because the sky has a slope there. The outer
// root crowds the rows at the horizon.
//
// The table holds fourth roots of the sums. In twilight the sums fall by orders of magnitude from texel to texel, and fourth roots make the error of
// linear interpolation 3 to 13 times smaller. A fourth root is two square roots, and a fourth power is two squares.
#include "sky/sums.glsl"

// Returns the place of a direction in the table: x across and y along, both in [0,1]. z is 1 below the horizon, and 0 above it. `horizon` is the sine
// of the visible horizon's elevation. `limb` is the sine of the elevation at which the air ends, or 1 for an observer inside the air. `sun_level` is
// the unit vector toward the sun's azimuth.
vec3 table_position(float horizon, float limb, vec3 view, vec3 sun_level) {
    float along_sun = view.x * sun_level.x + view.z * sun_level.z;
    float across = 0.5 - 0.5 * along_sun * inversesqrt(max(view.x * view.x + view.z * view.z, 1.0e-30));
    float above = view.y - horizon;
    float share = clamp(above / ((above >= 0.0 ? limb : -1.0) - horizon), 0.0, 1.0);
    // This is 1 - sqrt(1 - share), without cancellation.
    float along = share / (1.0 + sqrt(1.0 - share));
    return vec3(across, sqrt(sqrt(along)), above >= 0.0 ? 0.0 : 1.0);
}

// Returns the direction at a place of the table. At y = 0, on the horizon itself, the direction is just beside the horizon, on the side that z gives.
vec3 table_direction(float horizon, float limb, vec3 position, vec3 sun_level) {
    float squared = position.y * position.y;
    float along = squared * squared;
    float share = max(along * (2.0 - along), 1.0e-7);
    float sine = clamp(horizon + share * ((position.z > 0.5 ? -1.0 : limb) - horizon), -1.0, 1.0);
    float cosine = sqrt(max(1.0 - sine * sine, 0.0));
    float toward_sun = 1.0 - 2.0 * position.x;
    float aside = sqrt(max(1.0 - toward_sun * toward_sun, 0.0));
    return vec3(cosine * (toward_sun * sun_level.x + aside * sun_level.z), sine,
                cosine * (toward_sun * sun_level.z - aside * sun_level.x));
}
