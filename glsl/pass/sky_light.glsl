// The light of the sky's terms, for the skies that sum along the ray and for their table. A further term is added here.
#include <shade>

vec3 sky_light(SkySums sums, vec3 direction) {
    return sky_sums_radiance(sums, direction);
}
