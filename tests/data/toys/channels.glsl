// expect 3 4: 0 0 102
// warns channels.glsl:5: iChannel1 is black
void mainImage(out vec4 o, in vec2 p) {
    vec2 uv = p / iResolution.xy;
    vec4 seen = texture(iChannel1, uv) * 0.0;
    seen += texture2D(iChannel2, uv) + texelFetch(iChannel3, ivec2(0), 0) + textureLod(iChannel2, uv, 0.0);
    o = vec4(seen.rgb, 1.0) + vec4(0.0, 0.0, 0.4, 0.0);
}
