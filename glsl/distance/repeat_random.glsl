#include "distance/repeat.glsl"
#include "math/hash.glsl"

// Copies that differ: three random numbers in [0,1) for the copy with this index, to move it, to turn it or to choose its size.
//
// Copies that differ may be nearer than those which repeat_cell() looks at, but none is nearer than repeat_reach(), if each stays within half a spacing of
// its middle. So the least of all of them is never more than the distance, and has no seam:
//
//     float d = repeat_reach(spacing);
//     for (int i = 0; i < 4; i++) {
//         vec3 random = repeat_random(repeat_index(p, spacing, count, i), 1u);
//         d = min(d, distance_sphere(repeat_cell(p, spacing, count, i), 0.2 * (random - 0.5), 0.1 + 0.2 * random.x));
//     }
vec3 repeat_random(vec3 index, uint seed) {
    ivec3 copy = ivec3(floor(index));
    uvec3 bits = hash_3(uvec3(uint(copy.x), uint(copy.y), uint(copy.z)) + hash_3(uvec3(seed, 0u, 0u)));
    return vec3(unit_float(bits.x), unit_float(bits.y), unit_float(bits.z));
}

// Half the least spacing between copies.
float repeat_reach(vec3 spacing) {
    vec3 reach = vec3(INFINITY);
    if (spacing.x > 0.0) reach.x = spacing.x;
    if (spacing.y > 0.0) reach.y = spacing.y;
    if (spacing.z > 0.0) reach.z = spacing.z;
    return 0.5 * min(min(reach.x, reach.y), reach.z);
}
