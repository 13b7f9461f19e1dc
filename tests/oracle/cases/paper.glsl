// a: view, altitude; b: sun, ozone or not. c: the paper's sky by 16x4; d: its condition.
#include "../air.glsl"
#include "../item.glsl"
#include "sky/absorber_ozone.glsl"
#include "sky/paper.glsl"
#include "sky/view_column_whole.glsl"
#include "sky/sums_add.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    Atmosphere planet = air();
    planet.ozone_absorb_per_m *= b.w;
    SkySums sums = sky_paper(planet, a.w, vec3(a), vec3(b), 16, 4);
    c = vec4(sky_shade(planet, sums, vec3(a), vec3(b)), 0.0);
    d = vec4(grazing_condition(planet, a.w, (planet.planet_radius_m + a.w) * a.y), 0.0, 0.0, 0.0);
}
