#include "math/dialect.glsl"

// How much each of three patterns counts that are projected along x, y and z onto a surface, so that none is stretched:
//
//     vec3 share = triplanar(normal, 4.0);
//     share.x * pattern(vec2(p.y, p.z)) + share.y * pattern(vec2(p.x, p.z)) + share.z * pattern(vec2(p.x, p.y))
//
// The shares sum to 1. The larger the sharpness, the narrower is the band in which two patterns mix; at least 1.
vec3 triplanar(vec3 normal, float sharpness) {
    vec3 size = abs(normal);
    size = size / max(max(max(size.x, size.y), size.z), 1.0e-20);
    vec3 share = pow(size, vec3(max(sharpness, 1.0)));
    return share / (share.x + share.y + share.z);
}
