// a: view, altitude; b: sun, ozone or not. c: the sky by 8 nodes a segment; d: its condition.
#include "../air.glsl"
#include "../item.glsl"
#include "sky/absorber_ozone.glsl"

#include "sky/view_column_whole.glsl"
#include "sky/sums_add.glsl"

const int GAUSS_NODES = 8;

int gauss_count() {
    return GAUSS_NODES;
}
#include "sky/gauss.glsl"
#include "../gauss_table_8.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    Atmosphere planet = air();
    planet.ozone_absorb_per_m *= b.w;
    SkySums sums = sky_gauss(planet, gauss_table_8(), a.w, vec3(a), vec3(b));
    c = vec4(sky_shade(planet, sums, vec3(a), vec3(b)), 0.0);
    d = vec4(grazing_condition(planet, a.w, (planet.planet_radius_m + a.w) * a.y), 0.0, 0.0, 0.0);
}
