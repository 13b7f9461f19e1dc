// The sun's disk of a pass, and its radiance.
#include "math/cone.glsl"

uniform vec3 sun_disk_middle;       // toward it, unit length
uniform float sun_disk_one_less_cos; // of its angular radius
uniform vec3 sun_disk_heights;      // direction.y of the disk's lowest visible point and of its top
uniform sampler2D sun_disk_table;   // radiance along those, crowded at the lowest, reddened by the air before it

Cone sun_disk() {
    return Cone(sun_disk_middle, sun_disk_one_less_cos);
}

// 0 off the disk and below the horizon.
vec3 sun_radiance(vec3 direction) {
    float height = max(direction.y - sun_disk_heights.x, 0.0) / max(sun_disk_heights.y - sun_disk_heights.x, 1.0e-7);
    float columns = float(textureSize(sun_disk_table, 0).x);
    float across = (0.5 + sqrt(min(height, 1.0)) * (columns - 1.0)) / columns;
    bool visible = direction.y > sun_disk_heights.x && cone_holds(sun_disk(), direction);
    return visible ? textureLod(sun_disk_table, vec2(across, 0.5), 0.0).rgb : vec3(0.0);
}

// A direction uniform in the disk, from u in [0,1)^2; and what light of the radiance there weighs: over the density, sr.
vec3 sun_point(vec2 u) {
    return cone_sample(sun_disk(), u);
}

float sun_solid_angle() {
    return 2.0 * PI * sun_disk_one_less_cos;
}
