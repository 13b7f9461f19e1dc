// Ozone: a layer that absorbs light and does not scatter it. Its density falls linearly from 1 at its middle to 0 at half a width from there.
// The layer is cut at the top of the atmosphere. A column is the integral of the density along a ray, in metres.
#include "sky/atmosphere.glsl"

float absorber_density(Atmosphere a, float h) {
    return max(1.0 - abs(h - a.ozone_height_m) / a.ozone_half_width_m, 0.0);
}

// Returns the column between two altitudes at or above h, between which the density is linear. It uses Simpson's rule. The altitude along a ray is
// nearly a quadratic function of the distance, which the rule integrates exactly (to 1e-4 over the longest grazing path).
float absorber_slope(Atmosphere a, float h, float b, float low, float high) {
    float begin = distance_up(a, h, b, low);
    float end = distance_up(a, h, b, high);
    float middle = altitude_along(h, a.planet_radius_m + h, b, 0.5 * (begin + end));
    float sum = absorber_density(a, low) + 4.0 * absorber_density(a, middle) + absorber_density(a, high);
    return (end - begin) * sum / 6.0;
}

// Returns the column from altitude h up to the top. b must not be negative.
float absorber_column_up(Atmosphere a, float h, float b) {
    float low = clamp(a.ozone_height_m - a.ozone_half_width_m, h, max(h, a.thickness_m));
    float middle = clamp(a.ozone_height_m, h, max(h, a.thickness_m));
    float high = clamp(a.ozone_height_m + a.ozone_half_width_m, h, max(h, a.thickness_m));
    return absorber_slope(a, h, b, low, middle) + absorber_slope(a, h, b, middle, high);
}

float absorber_column_level(Atmosphere a, float h, float b) {
    return absorber_column_up(a, perigee_altitude(h, a.planet_radius_m + h, b), 0.0);
}

// Returns the column from altitude h to the top. A ray that descends (b < 0) must miss the ground.
float absorber_column_to_top(Atmosphere a, float h, float b) {
    float up = absorber_column_up(a, h, abs(b));
    float through = max(2.0 * absorber_column_level(a, h, b) - up, 0.0);
    return b < 0.0 ? through : up;
}

// Returns the column from altitude h to the point at distance t along the ray, which has altitude h_t.
float absorber_column_between(Atmosphere a, float h, float b, float h_t, float t) {
    float b_t = b + t;
    float begin = absorber_column_up(a, h, abs(b));
    float end = absorber_column_up(a, h_t, abs(b_t));
    if (b >= 0.0) return max(begin - end, 0.0);
    if (b_t <= 0.0) return max(end - begin, 0.0);
    return max(2.0 * absorber_column_level(a, h, b) - begin - end, 0.0);
}
