// Whether all components are finite. By bits: GLSL does not promise that isnan() sees anything.
bool is_finite(vec3 v) {
    uvec3 exponent = floatBitsToUint(v) & uvec3(0x7f800000u);
    return exponent.x != 0x7f800000u && exponent.y != 0x7f800000u && exponent.z != 0x7f800000u;
}
