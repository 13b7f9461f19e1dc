// Says whether all components are finite. It looks at the bits, because GLSL does not promise that isnan() works.
bool is_finite(vec3 v) {
    uvec3 exponent = floatBitsToUint(v) & uvec3(0x7f800000u);
    return exponent.x != 0x7f800000u && exponent.y != 0x7f800000u && exponent.z != 0x7f800000u;
}
