#include "math/hash.glsl"

// Returns a random number in [0,1) for a point with whole coordinates.
float noise_at(ivec3 corner) {
    return unit_float(hash_3(uvec3(corner)).x);
}

// Value noise in [0,1]. It is random at points with whole coordinates, and smooth between them (by Perlin's quintic of 2002).
float noise(vec3 position) {
    vec3 low = floor(position);
    vec3 f = position - low;
    vec3 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec3 rest = 1.0 - s;
    ivec3 c = ivec3(low);
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
        ivec3 corner = ivec3(i % 2, i / 2 % 2, i / 4);
        vec3 w = vec3(corner.x == 1 ? s.x : rest.x, corner.y == 1 ? s.y : rest.y, corner.z == 1 ? s.z : rest.z);
        sum += w.x * w.y * w.z * noise_at(c + corner);
    }
    return min(sum, 1.0);
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
