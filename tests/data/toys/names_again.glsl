// expect 10 15: 64 128 51
vec2 iMouse = vec2(0.2);
float iDate(float x) { return x; }
void mainImage(out vec4 O, in vec2 I) {
    vec2 iResolution = iResolution.xy;
    O = vec4(floor(I) / iResolution, iMouse.x, 1.0);
}
