// A sky method that is computed anew for each direction.
#include <sums>

vec3 sky_radiance(vec3 direction) {
    return sky_shade(atmosphere, sky_sums(direction), direction, sun_direction);
}
