// The sky as a table: how directions map to the unit square. The phase-free sums depend on the direction's elevation and on
// its azimuth from the sun's, evenly.
//
// Across: (1 - cos(azimuth from the sun)) / 2, in which an even function stays smooth, and no arc tangent is needed.
// Along: the fourth root of 1 - sqrt(1 - share), where `share` is the sine of elevation above the visible horizon (or below it)
// scaled to 1 at the zenith (nadir). The inner root makes it linear in the angle from the zenith, across which the sky has a slope; the
// outer one crowds the rows at the horizon.
// Held: the sums' fourth roots. Twilight falls by orders of magnitude from texel to texel; with its fourth root linear
// interpolation errs 3 to 13 times less. Roots and powers of four are two square roots and two squares.
#include "sky/sums.glsl"

vec3 fourth_root(vec3 v) {
    return sqrt(sqrt(v));
}

vec3 fourth_power(vec3 v) {
    vec3 squared = v * v;
    return squared * squared;
}

// Where `view` lies in the table, between the sines of elevation of the visible `horizon` and of the `limb` where the air ends (1 from
// inside): x across, y along, both in [0,1]; z is 1 below the horizon, else 0. `sun_level` is the
// unit vector toward the sun's azimuth.
vec3 table_position(float horizon, float limb, vec3 view, vec3 sun_level) {
    float along_sun = view.x * sun_level.x + view.z * sun_level.z;
    float across = 0.5 - 0.5 * along_sun * inversesqrt(max(view.x * view.x + view.z * view.z, 1.0e-30));
    float above = view.y - horizon;
    float share = clamp(above / ((above >= 0.0 ? limb : -1.0) - horizon), 0.0, 1.0);
    float along = share / (1.0 + sqrt(1.0 - share)); // 1 - sqrt(1 - share)
    return vec3(across, sqrt(sqrt(along)), above >= 0.0 ? 0.0 : 1.0);
}

// The direction that lies there. On the horizon itself (y = 0) it is taken just beside it, on its own side.
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
