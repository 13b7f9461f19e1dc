// expect 10 20: 64 170 128
void mainImage(out vec4 c, in vec2 p) {
    vec2 at = floor(p);
    c = vec4(at.x * 6.4 / 255.0, at.y * 8.5 / 255.0, 128.0 / 255.0, 1.0);
}
