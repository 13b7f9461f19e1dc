// expect 10 20: 0 204 51
uniform vec3 iResolution;
uniform float iGlobalTime;
vec4 image(vec2 p);
void main() {
    gl_FragColor = image(gl_FragCoord.xy);
    if (gl_FragCoord.y < iResolution.y) return;
    gl_FragColor = vec4(1.0);
}
vec4 image(vec2 p) { return vec4(0.0, 0.4 * iGlobalTime, 0.2, 1.0); }
