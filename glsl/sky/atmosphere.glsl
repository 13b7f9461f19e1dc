// A planet's shell of air and aerosols: geometry in forms that lose nothing in float. A point is its altitude h above
// the ground, never its distance r = R + h from the centre alone: R in float is rounded to half a metre. A direction at
// a point is b = r cos(angle to the zenith), which grows by t along a ray.
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
    vec3 ozone_absorb_per_m;       // at the middle of its layer
    float ozone_height_m;          // of the layer's middle
    float ozone_half_width_m;
    vec3 sun_irradiance;           // above the atmosphere
};

// The part of a ray that runs through air, distances in m; empty where begin == end.
struct Segment {
    float begin;
    float end;
};

// Densities of air and aerosols at an altitude, as shares of those on the ground.
vec2 densities(Atmosphere a, float h) {
    return exp(vec2(-h / a.rayleigh_scale_height_m, -h / a.mie_scale_height_m));
}

// Altitude after a distance t along a ray that starts at altitude h.
float altitude_along(float h, float r, float b, float t) {
    float q = t * (2.0 * b + t);
    return max(h + q / (sqrt(max(r * r + q, 0.0)) + r), 0.0);
}

// Lowest altitude of the line through a point at altitude h.
float perigee_altitude(float h, float r, float b) {
    float c = b / r;
    return max(h - r * c * c / (1.0 + sqrt(max(1.0 - c * c, 0.0))), 0.0);
}

// Distance up to an altitude `top` at or above h.
float distance_up(Atmosphere a, float h, float b, float top) {
    float c = max((top - h) * (2.0 * a.planet_radius_m + h + top), 0.0);
    float root = sqrt(b * b + c);
    return b > 0.0 ? c / (b + root) : root - b;
}

float distance_to_top(Atmosphere a, float h, float b) {
    return distance_up(a, h, b, a.thickness_m);
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

// Whether the planet hides the sun from altitude h; b is the sun's.
bool in_planet_shadow(Atmosphere a, float h, float b) {
    return b < 0.0 && h * (2.0 * a.planet_radius_m + h) < b * b;
}

// The part of a ray in the shadow of a planet higher by `lift` than this one, a half cylinder: from altitude h along `view`, whose
// b is given. Distances may lie behind the ray's origin; begin == end where there is none.
Segment shadow_segment(Atmosphere a, float lift, float h, float b, vec3 view, vec3 sun) {
    float nu = dot(view, sun);
    float b_sun = (a.planet_radius_m + h) * sun.y;
    vec3 across = view - nu * sun;
    float squared = max(dot(across, across), 1.0e-30);
    float half_linear = b - b_sun * nu;
    float constant = (h - lift) * (2.0 * a.planet_radius_m + h + lift) - b_sun * b_sun;
    float discriminant = half_linear * half_linear - squared * constant;
    if (discriminant <= 0.0) return Segment(0.0, 0.0);
    float q = -half_linear - (half_linear >= 0.0 ? 1.0 : -1.0) * sqrt(discriminant);
    float first = q / squared;
    float second = constant / (q == 0.0 ? 1.0e-30 : q);
    float begin = min(first, second);
    float end = max(first, second);
    // Behind the plane through the planet's centre, square to the sun.
    float middle = -b_sun / (abs(nu) < 1.0e-30 ? 1.0e-30 : nu);
    if (nu >= 0.0) return Segment(min(begin, middle), min(end, middle));
    return Segment(max(begin, middle), max(end, middle));
}
