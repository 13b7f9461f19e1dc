// A sky method that is computed anew for each direction.
#include <light-sums>
#include "pass/sky_light.glsl"

vec3 sky_radiance(vec3 direction) {
    return sky_light(sky_light_sums(direction), direction);
}
