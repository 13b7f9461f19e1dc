#include "math/hash.glsl"

// Rolling ground. hills() returns a height in [0,1] for each (x, z). It is random at whole coordinates and smooth between them (value
// noise with Perlin's quintic of 2002).
//
// The slope of hills() is at most HILLS_SLOPE. The slope of height * hills(at / length) is at most HILLS_SLOPE * height / length. If heights
// are added, their slopes add. If the ground h has a slope of at most s, this is the distance to it, or less:
//
//     (p.y - h(vec2(p.x, p.z))) / length(vec2(1.0, s))
const float HILLS_SLOPE = 1.875;

float hills_at(ivec2 corner) {
    return unit_float(hash_3(uvec3(uint(corner.x), uint(corner.y), 0u)).x);
}

float hills(vec2 at) {
    vec2 low = floor(at);
    vec2 f = at - low;
    vec2 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    ivec2 c = ivec2(low);
    float near = mix(hills_at(c), hills_at(c + ivec2(1, 0)), s.x);
    float far = mix(hills_at(c + ivec2(0, 1)), hills_at(c + ivec2(1, 1)), s.x);
    return mix(near, far, s.y);
}
