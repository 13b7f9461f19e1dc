// The radiance that sums in the settings' three channels make.
#include "pass/atmosphere.glsl"
#include "sky/sums.glsl"

vec3 sky_sums_radiance(SkySums sums, vec3 direction) {
    return sky_shade(atmosphere, sums, direction, sun_direction);
}
