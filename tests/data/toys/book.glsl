#ifdef GL_ES
precision mediump float;
#endif
// expect 10 15: 64 128 102
uniform vec2 u_resolution;
uniform vec2 u_mouse;
uniform float u_time;
void main() {
    vec2 st = floor(gl_FragCoord.xy) / u_resolution.xy;
    gl_FragColor = vec4(st, 0.2 * u_time + u_mouse.x * 0.0, 1.0);
}
