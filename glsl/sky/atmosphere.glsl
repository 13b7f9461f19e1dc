// A planet's shell of air and aerosols. The geometry is written in forms that lose no digits in float.
//
// A point is given by its altitude h above the ground, and never by its distance r = R + h from the centre alone, because float rounds R to half a
// metre. A direction at a point is given by b = r cos(angle to the zenith). Along a ray, b grows by the distance t.
#include "math/dialect.glsl"

struct Atmosphere {
    // R, the distance from the planet's centre to the ground.
    float planet_radius_m;
    // All densities are 0 above this altitude.
    float thickness_m;
    float rayleigh_scale_height_m;
    float mie_scale_height_m;
    // Scattering by air at altitude 0. Extinction by air is the same.
    vec3 rayleigh_scatter_per_m;
    // Scattering and extinction by aerosols at altitude 0.
    vec3 mie_scatter_per_m;
    vec3 mie_extinction_per_m;
    // The asymmetry of the aerosols' phase function.
    float mie_g;
    // Absorption at the middle of the ozone layer.
    vec3 ozone_absorb_per_m;
    // The altitude of the layer's middle.
    float ozone_height_m;
    float ozone_half_width_m;
    // The sun's irradiance above the atmosphere.
    vec3 sun_irradiance;
};

// A part of a ray, as distances from its origin in metres. It is empty if begin == end.
struct Segment {
    float begin;
    float end;
};

// Returns the densities of air and aerosols at an altitude, as shares of the densities on the ground.
vec2 densities(Atmosphere a, float h) {
    return exp(vec2(-h / a.rayleigh_scale_height_m, -h / a.mie_scale_height_m));
}

// Returns the altitude at distance t along a ray that starts at altitude h.
float altitude_along(float h, float r, float b, float t) {
    float q = t * (2.0 * b + t);
    return max(h + q / (sqrt(max(r * r + q, 0.0)) + r), 0.0);
}

// Returns the lowest altitude (the perigee) of the line through a point at altitude h.
float perigee_altitude(float h, float r, float b) {
    float c = b / r;
    return max(h - r * c * c / (1.0 + sqrt(max(1.0 - c * c, 0.0))), 0.0);
}

// Returns the distance along a ray from altitude h up to the altitude `top`, which must not be below h.
float distance_up(Atmosphere a, float h, float b, float top) {
    float c = max((top - h) * (2.0 * a.planet_radius_m + h + top), 0.0);
    float root = sqrt(b * b + c);
    float rising = c / (b + root);
    float falling = root - b;
    return b > 0.0 ? rising : falling;
}

float distance_to_top(Atmosphere a, float h, float b) {
    return distance_up(a, h, b, a.thickness_m);
}

// Returns the part of a ray in the atmosphere. It begins at the ray's origin if that is inside, and ends at the top or at the ground.
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

// Says whether the planet hides the sun from a point at altitude h. b is that of the direction to the sun.
bool in_planet_shadow(Atmosphere a, float h, float b) {
    return b < 0.0 && h * (2.0 * a.planet_radius_m + h) < b * b;
}

// Returns the part of a ray in the shadow of a planet whose radius is larger by `lift`. The ray starts at altitude h and goes along `view`, and b is
// that of `view`. The shadow is half of a cylinder. The distances may be negative. The segment is empty if the ray misses the shadow.
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
    // Only the half of the cylinder behind the planet's centre is shadow.
    float middle = -b_sun / (abs(nu) < 1.0e-30 ? 1.0e-30 : nu);
    if (nu >= 0.0) return Segment(min(begin, middle), min(end, middle));
    return Segment(max(begin, middle), max(end, middle));
}
