// expect 3 4: 51 102 153
#ifdef GL_OES_standard_derivatives
#endif
float one() { return 1.0; }
#extension GL_OES_standard_derivatives : enable
#extension GL_EXT_shader_texture_lod : require
#extension GL_ARB_texture_query_levels : enable
void mainImage(out vec4 o, in vec2 p) {
    vec2 slope = vec2(dFdx(p.x), fwidth(p.y));
    o = vec4(0.2 * slope.x, 0.4 * slope.y, 0.6 * one(), 1.0) + texture2DLodEXT(iChannel0, p, 0.0) * 0.0;
}
