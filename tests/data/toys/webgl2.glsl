// expect 10 20: 128 0 51
void mainImage(out vec4 O, in vec2 I) {
    uint bits = packHalf2x16(vec2(0.5, 0.0));
    float list[] = float[](0.0, 0.2);
    uvec2 u = uvec2(I) ^ uvec2(1u);
    mat2x3 m = mat2x3(1.0);
    O = vec4(unpackHalf2x16(bits).x, float(u.x >> 31) + determinant(mat2(0.0)), list[1] * m[0].x, 1.0);
}
