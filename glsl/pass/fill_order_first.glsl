#version 330 core
// The field of order 1, at each point of the grid and in each direction: sunlight that was scattered once, by the air or by the ground. The sun's
// irradiance counts as 1.
const int ORDER_BANDS = 1;
#include "pass/orders.glsl"
#include "pass/order_directions.glsl"
#include "pass/order_nodes.glsl"

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
    SkySums sums = sky_gauss(air, order_gauss, point.h, view, point.sun);
    vec3 sky = sums.rayleigh * air.rayleigh_scatter_per_m * rayleigh_phase(view, point.sun) +
               sums.mie * air.mie_scatter_per_m * mie_phase(air.mie_g, view, point.sun);
    OrderRay ray = order_ray(air, point.h, view, point.sun, order_ray_texel(order_grid, point, texel.x, 2 * rays_nodes + 1));
    vec3 ground = order_end_kept(ray, 0) * band_ground(point.band) / PI * order_sunlight(air, order_end_sine(air, ray));
    light = vec4((sky + ground) * direction.solid_angle, 0.0);
    angles = order_angles(point, direction, view);
}
