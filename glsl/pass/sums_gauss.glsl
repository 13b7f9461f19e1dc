// --sky gauss:n
#include "pass/atmosphere.glsl"
#include <absorber>
#include <gauss-nodes>
#include "sky/gauss.glsl"

uniform GaussTable gauss_table;

SkySums sky_sums(vec3 direction) {
    return sky_gauss(atmosphere, gauss_table, observer_height_m, direction, sun_direction);
}
