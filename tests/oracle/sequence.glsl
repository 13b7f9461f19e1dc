// a: pixel (x, y), the sample's index, seed. c: the first two pairs; d: hash_3 of the first three by 24 bits, and the 8
// bits left of each.
void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    Sequence sequence = sequence_start(uint(a.x), uint(a.y), uint(a.z), uint(a.w));
    vec2 first = sequence_pair(sequence);
    vec2 second = sequence_pair(sequence);
    uvec3 hash = hash_3(uvec3(uint(a.x), uint(a.y), uint(a.z)));
    uint rest = ((hash.x & 255u) << 16u) | ((hash.y & 255u) << 8u) | (hash.z & 255u);
    c = vec4(first.x, first.y, second.x, second.y);
    d = vec4(float(hash.x >> 8u), float(hash.y >> 8u), float(hash.z >> 8u), float(rest));
}
