// expect 10 15: 64 128 204
uniform float time;
uniform vec2 mouse;
uniform vec2 resolution;
uniform sampler2D backbuffer;
float shade(float time) { return 0.4 * time; }
void main(void) {
    vec2 position = floor(gl_FragCoord.xy) / resolution.xy + mouse * 0.0;
    gl_FragColor = vec4(position, shade(time), 1.0) + 0.0 * texture2D(backbuffer, position);
}
