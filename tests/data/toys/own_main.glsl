// expect 10 20: 64 170 51
void mainImage(out vec4 c, in vec2 p) {
    c = vec4(floor(p) * vec2(6.4, 8.5) / 255.0, 0.0, 1.0);
}
void main(void) {
    vec4 color;
    mainImage(color, gl_FragCoord.xy);
    gl_FragColor = color;
    gl_FragColor.b += 0.2;
}
