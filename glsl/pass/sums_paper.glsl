// --sky paper:NxM
#include "pass/atmosphere.glsl"
#include <absorber>
#include <view-column>
#include <sums-add>
#include "sky/paper.glsl"

uniform int sky_view_samples;
uniform int sky_light_samples;

SkySums sky_sums(Atmosphere air, vec3 direction) {
    return sky_paper(air, observer_height_m, direction, sun_direction, sky_view_samples, sky_light_samples);
}
