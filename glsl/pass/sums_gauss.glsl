// --sky gauss:n
#include "pass/atmosphere.glsl"
#include <absorber>
#include <view-column>
#include <sums-add>
#include <gauss-nodes>
#include "sky/gauss.glsl"

uniform GaussTable gauss_table;

SkySums sky_sums(Atmosphere air, vec3 direction) {
    return sky_gauss(air, gauss_table, observer_height_m, direction, sun_direction);
}
