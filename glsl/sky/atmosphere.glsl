// A planet's shell of air and aerosols: geometry in forms that lose nothing in float. A point is its altitude h above
// the ground, never its distance r = R + h from the centre alone: R in float is rounded to half a metre.
#include "math/dialect.glsl"

struct Atmosphere {
    float planet_radius_m;         // R
    float thickness_m;             // density is 0 above this altitude
    float rayleigh_scale_height_m;
    float mie_scale_height_m;
    vec3 rayleigh_scatter_per_m;   // at altitude 0; extinction is the same
    vec3 mie_scatter_per_m;        // at altitude 0
    vec3 mie_extinction_per_m;     // at altitude 0
    float mie_g;                   // asymmetry
    vec3 sun_irradiance;           // above the atmosphere
};

// The part of a ray that runs through air, distances in m; empty where begin == end.
struct Segment {
    float begin;
    float end;
};

// Altitude after a distance t along a ray that starts at altitude h, r = R + h, with b = r cos(zenith angle).
float altitude_along(float h, float r, float b, float t) {
    float q = t * (2.0 * b + t);
    return max(h + q / (sqrt(max(r * r + q, 0.0)) + r), 0.0);
}

// Distance to the top of the atmosphere from an altitude h below it; b = r cos(zenith angle).
float distance_to_top(Atmosphere a, float h, float b) {
    float c = max((a.thickness_m - h) * (2.0 * a.planet_radius_m + h + a.thickness_m), 0.0);
    float root = sqrt(b * b + c);
    return b > 0.0 ? c / (b + root) : root - b;
}

// The ray's part between its entry into the atmosphere (its origin, if that is inside) and the top or the ground.
Segment atmosphere_segment(Atmosphere a, float h, float b) {
    float to_ground = h * (2.0 * a.planet_radius_m + h);
    float ground = b * b - to_ground;
    bool hits_ground = b < 0.0 && ground >= 0.0;
    float ground_distance = to_ground / max(-b + sqrt(max(ground, 0.0)), 1.0e-30);
    if (h <= a.thickness_m) return Segment(0.0, hits_ground ? ground_distance : distance_to_top(a, h, b));

    float c = (h - a.thickness_m) * (2.0 * a.planet_radius_m + h + a.thickness_m);
    float top = b * b - c;
    if (b >= 0.0 || top <= 0.0) return Segment(0.0, 0.0);
    float root = sqrt(top);
    return Segment(c / (root - b), hits_ground ? ground_distance : root - b);
}

// Whether the planet hides the sun from altitude h; b = r cos(angle between zenith and sun).
bool in_planet_shadow(Atmosphere a, float h, float b) {
    return b < 0.0 && h * (2.0 * a.planet_radius_m + h) < b * b;
}
