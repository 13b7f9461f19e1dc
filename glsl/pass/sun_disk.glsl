// The sun's disk and its radiance.
#include "math/cone.glsl"

// Toward the disk's middle, a unit vector.
uniform vec3 sun_disk_middle;
// 1 minus the cosine of the disk's angular radius.
uniform float sun_disk_one_less_cos;
// direction.y of the disk's lowest visible point and of its top.
uniform vec3 sun_disk_heights;
// The radiance between these heights, reddened by the air in front. Texels are closest at the lowest point.
uniform sampler2D sun_disk_table;

Cone sun_disk() {
    return Cone(sun_disk_middle, sun_disk_one_less_cos);
}

// The radiance is 0 off the disk and below the horizon.
vec3 sun_radiance(vec3 direction) {
    float height = max(direction.y - sun_disk_heights.x, 0.0) / max(sun_disk_heights.y - sun_disk_heights.x, 1.0e-7);
    float columns = float(textureSize(sun_disk_table, 0).x);
    float across = (0.5 + sqrt(min(height, 1.0)) * (columns - 1.0)) / columns;
    bool visible = direction.y > sun_disk_heights.x && cone_holds(sun_disk(), direction);
    vec3 radiance = textureLod(sun_disk_table, vec2(across, 0.5), 0.0).rgb;
    return visible ? radiance : vec3(0.0);
}

// A direction uniform in the disk, from u in [0,1)^2. The disk's solid angle, sr, is one over the density of these directions.
vec3 sun_point(vec2 u) {
    return cone_sample(sun_disk(), u);
}

vec3 sun_middle() {
    return sun_disk_middle;
}

float sun_solid_angle() {
    return 2.0 * PI * sun_disk_one_less_cos;
}

// The half-angle is 20 degrees: wide enough for some of a few thousand paths to meet the cone, and so narrow that a mirror which throws
// no sunlight into the scene seldom throws the cone's.
const float SUN_NEAR_COS = 0.9397;
const float SUN_NEAR_SIN = 0.342;

bool sun_is_near(vec3 direction) {
    return dot(direction, sun_disk_middle) > SUN_NEAR_COS;
}

// The solid angle of the cone, sr. Of a low sun's cone, the part below the horizon is left out.
float sun_near_solid_angle() {
    float above = clamp(0.5 + 0.5 * sun_disk_middle.y / SUN_NEAR_SIN, 0.1, 1.0);
    return 2.0 * PI * (1.0 - SUN_NEAR_COS) * above;
}

// The irradiance of a surface that faces the disk.
vec3 sun_irradiance() {
    return sun_solid_angle() * textureLod(sun_disk_table, vec2(0.7, 0.5), 0.0).rgb;
}

// The radiance of the cone if the disk's light came evenly from it.
vec3 sun_spread() {
    return sun_irradiance() / sun_near_solid_angle();
}
