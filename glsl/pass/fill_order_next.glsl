#version 330 core
// The field of an order beyond the first, at each point of the grid and in each direction, from the moments of the order before: what these scatter
// along the ray, and what the ground at the ray's end reflects of their light.
const int ORDER_BANDS = 1;
#include "pass/orders.glsl"
#include "pass/order_directions.glsl"

uniform sampler2D order_before;
// The degree up to which the texture has harmonics, and the degree up to which they are used.
uniform int order_before_degree;
uniform int order_most;

// The radiance times the direction's solid angle.
layout(location = 0) out vec4 light;
// What order_angles() returns.
layout(location = 1) out vec4 angles;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    OrderPoint point = order_point(order_grid, atmosphere.thickness_m, texel.y);
    Atmosphere air = band_air(point.band);
    OrderDirection direction = order_direction(air.planet_radius_m, point.h, texel.x);
    vec3 view = order_view(direction);
    OrderRay ray = order_ray(air, point.h, view, point.sun, order_ray_texel(order_grid, point, texel.x, 2 * rays_nodes + 1));
    vec3 sky[ORDER_BANDS];
    order_gather(order_before, order_before_degree, order_most, point.band, air, ray, 0, sky);
    vec3 irradiance = order_ground(order_before, order_before_degree, point.band, air, order_end_sine(air, ray));
    vec3 ground = order_end_kept(ray, 0) * band_ground(point.band) / PI * irradiance;
    light = vec4((sky[0] + ground) * direction.solid_angle, 0.0);
    angles = order_angles(point, direction, view);
}
