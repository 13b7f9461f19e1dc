#version 330 core
// The sky as a list of small patches, one a texel, for integrals over it: across, azimuth from the sun's on one side of it (the
// sky is even about the sun); along, elevation, rows crowded at the visible horizon, those above it first.
#include <sky>
#include "pass/sun.glsl"
#include "math/dialect.glsl"

uniform vec3 patch_count; // across, along above the horizon, along below it
uniform float patch_horizon;

layout(location = 0) out vec4 patch_light;     // radiance times the patch's solid angle; that angle
layout(location = 1) out vec4 patch_direction; // toward the sun's azimuth, up, aside

void main() {
    vec2 texel = floor(gl_FragCoord.xy);
    bool below = texel.y >= patch_count.y;
    float rows = below ? patch_count.z : patch_count.y;
    float w = (texel.y - (below ? patch_count.y : 0.0) + 0.5) / rows;
    float reach = (below ? -1.0 : 1.0) - patch_horizon; // of the sine of elevation
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
