// The paper's sky, short: 4x2.
#include "air.glsl"
#include "sky/absorber_none.glsl"
#include "sky/paper.glsl"
#include "sky/view_column_whole.glsl"
#include "sky/sums_add.glsl"

vec3 sun_direction;

void prepare_sky(vec3 sun) {
    sun_direction = sun;
}

vec3 sky_radiance(vec3 direction) {
    return sky_shade(air(), sky_paper(air(), 1.0, direction, sun_direction, 4, 2), direction, sun_direction);
}
