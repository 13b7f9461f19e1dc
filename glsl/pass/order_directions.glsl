// The directions in which the field of an order is computed at a point, one for each texel across. They are the nodes of a quadrature over the
// sphere.
//
// Elevations have the nodes of Gauss-Legendre quadrature in u, where u^2 is the share of the way from the sine of the local horizon to that of the
// zenith or the nadir. So directions crowd at the horizon, and none of the two parts crosses it, because a field jumps there. Azimuths are the
// middles of equal parts of the half turn on one side of the sun. The other side is its mirror image.
#include "sky/orders.glsl"

// The numbers of elevations above the horizon, of those below it, and of azimuths.
uniform vec3 order_directions;
// The nodes of u and their weights: first those above the horizon, then those below.
uniform float order_elevation[32];
uniform float order_elevation_weight[32];

struct OrderDirection {
    // The sine of the direction's elevation.
    float mu;
    float cos_azimuth;
    float sin_azimuth;
    // The solid angle for which the direction and its mirror image stand, in steradians.
    float solid_angle;
};

// Returns the sine of elevation of the horizon that is seen from altitude h.
float order_horizon(float planet_radius_m, float h) {
    return -sqrt(h * (2.0 * planet_radius_m + h)) / (planet_radius_m + h);
}

// Returns the difference of the sines from the horizon to the zenith, or to the nadir (below 0) if elevation number `elevation` lies below the
// horizon.
float order_reach(float horizon, int elevation) {
    return (elevation < int(order_directions.x + 0.5) ? 1.0 : -1.0) - horizon;
}

// Returns the sine of elevation number `elevation` at altitude h.
float order_elevation_sine(float planet_radius_m, float h, int elevation) {
    float horizon = order_horizon(planet_radius_m, h);
    float u = order_elevation[elevation];
    return horizon + order_reach(horizon, elevation) * u * u;
}

OrderDirection order_direction(float planet_radius_m, float h, int index) {
    int azimuths = int(order_directions.z + 0.5);
    int elevation = index / azimuths;
    float reach = order_reach(order_horizon(planet_radius_m, h), elevation);
    float u = order_elevation[elevation];
    float azimuth = PI * (float(index - elevation * azimuths) + 0.5) / order_directions.z;
    return OrderDirection(order_elevation_sine(planet_radius_m, h, elevation), cos(azimuth), sin(azimuth),
                          abs(reach) * 2.0 * u * order_elevation_weight[elevation] * 2.0 * PI / order_directions.z);
}

// The point of the grid for which a row of the textures of light stands. Points follow each other along a row of the grid, row by row, band by band.
struct OrderPoint {
    int band;
    // The row of the grid, and its altitude in metres.
    int row;
    float h;
    // The direction to the sun. y points to the zenith, and x is level and toward the sun.
    vec3 sun;
};

OrderPoint order_point(OrderGrid grid, float top, int row) {
    int columns = int(grid.columns + 0.5);
    int points = columns * int(grid.rows + 0.5);
    int point = row % points;
    vec2 sun = order_sun(grid, float(point % columns));
    return OrderPoint(row / points, point / columns, order_altitude(grid, top, float(point / columns)), vec3(sun, 0.0));
}

vec3 order_view(OrderDirection direction) {
    float level = sqrt(max(1.0 - direction.mu * direction.mu, 0.0));
    return vec3(level * direction.cos_azimuth, direction.mu, level * direction.sin_azimuth);
}

// Returns what moments need to know of a direction: its cosine to the sun, the cosine of its azimuth about the sun, and the sine of its elevation.
vec4 order_angles(OrderPoint point, OrderDirection direction, vec3 view) {
    float nu = dot(view, point.sun);
    return vec4(nu, order_azimuth(direction.mu, point.sun.y, point.sun.x, nu), direction.mu, 0.0);
}

// Returns the first texel of the ray in direction number `index` (pass/fill_order_rays.glsl). `texels` is the number of texels of a ray.
ivec2 order_ray_texel(OrderGrid grid, OrderPoint point, int index, int texels) {
    int elevation = index / int(order_directions.z + 0.5);
    return ivec2(elevation * texels, point.band * int(grid.rows + 0.5) + point.row);
}
