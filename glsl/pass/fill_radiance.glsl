#version 330 core
// The sky as a list of small patches, one in each texel, for integrals over it. Across runs the azimuth from the sun's, on one side
// of it (the other side is its mirror image). Along runs the elevation; rows are closest at the visible horizon, and those above it
// come first.
#include <sky>
#include "pass/sun.glsl"
#include "math/dialect.glsl"

// Patches across, along above the horizon, and along below it.
uniform vec3 patch_count;
uniform float patch_horizon;

// The radiance times the patch's solid angle, and the solid angle in sr.
layout(location = 0) out vec4 patch_light;
// Components toward the sun's azimuth, up, and sideways.
layout(location = 1) out vec4 patch_direction;

void main() {
    vec2 texel = floor(gl_FragCoord.xy);
    bool below = texel.y >= patch_count.y;
    float rows = below ? patch_count.z : patch_count.y;
    float w = (texel.y - (below ? patch_count.y : 0.0) + 0.5) / rows;
    // The range of the sine of elevation.
    float reach = (below ? -1.0 : 1.0) - patch_horizon;
    float sine = patch_horizon + reach * w * w;
    float cosine = sqrt(max(1.0 - sine * sine, 0.0));
    float azimuth = PI * (texel.x + 0.5) / patch_count.x;
    vec3 direction = vec3(cosine * cos(azimuth), sine, cosine * sin(azimuth));
    float solid_angle = abs(reach) * 2.0 * w / rows * PI / patch_count.x;
    vec3 aside = vec3(sun_level.z, 0.0, -sun_level.x);
    vec3 radiance = sky_radiance(direction.x * sun_level + direction.z * aside + vec3(0.0, direction.y, 0.0));
    patch_light = vec4(radiance * solid_angle, solid_angle);
    patch_direction = vec4(direction, 0.0);
}
