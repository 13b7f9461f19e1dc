#include "math/hash.glsl"

// Returns a random number in [0,1) for a point with whole coordinates.
float noise_at(ivec3 corner) {
    return unit_float(hash_3(uvec3(corner)).x);
}

// How much the upper corners of a cell count at the place f in it, 0 to 1 along each axis: Perlin's quintic of 2002.
vec3 noise_blend(vec3 f) {
    return f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
}

// How much a corner of a cell counts along each axis. `s` is what noise_blend() returns, and a corner's coordinates are 0 or 1.
vec3 noise_shares(vec3 s, ivec3 corner) {
    vec3 rest = 1.0 - s;
    return vec3(corner.x == 1 ? s.x : rest.x, corner.y == 1 ? s.y : rest.y, corner.z == 1 ? s.z : rest.z);
}

// Value noise in [0,1]. It is random at points with whole coordinates, and smooth between them.
float noise(vec3 position) {
    vec3 low = floor(position);
    vec3 s = noise_blend(position - low);
    ivec3 c = ivec3(low);
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
        ivec3 corner = ivec3(i % 2, i / 2 % 2, i / 4);
        vec3 w = noise_shares(s, corner);
        sum += w.x * w.y * w.z * noise_at(c + corner);
    }
    return min(sum, 1.0);
}

// Three such noises that are independent of each other. The first is noise().
vec3 noise_vector(vec3 position) {
    vec3 low = floor(position);
    vec3 s = noise_blend(position - low);
    ivec3 c = ivec3(low);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 8; i++) {
        ivec3 corner = ivec3(i % 2, i / 2 % 2, i / 4);
        vec3 w = noise_shares(s, corner);
        uvec3 bits = hash_3(uvec3(c + corner));
        sum += w.x * w.y * w.z * vec3(unit_float(bits.x), unit_float(bits.y), unit_float(bits.z));
    }
    return min(sum, vec3(1.0));
}

// A sum of octaves of noise(), scaled to [0,1]. Each octave is half as large and half as strong as the one before.
float noise_octaves(vec3 position, int octaves) {
    float sum = 0.0;
    float total = 0.0;
    float strength = 1.0;
    float scale = 1.0;
    for (int i = 0; i < octaves; i++) {
        sum += strength * noise(scale * position + vec3(float(i) * 17.0));
        total += strength;
        strength *= 0.5;
        scale *= 2.0;
    }
    return min(sum / total, 1.0);
}
