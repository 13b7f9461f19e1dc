// The sums of the sky's light in the settings' three channels.
#include <sums>

SkySums sky_light_sums(vec3 direction) {
    return sky_sums(atmosphere, direction);
}
