// warns its loops turn more often
void mainImage(out vec4 O, in vec2 I) {
    float sum;
    for (int i = 0; i < 300; i++) {
        for (int k = 0; k < 300 + int(min(I.x, 0.0)); k++) sum += fract(sin(float(i + k)));
    }
    O = vec4(fract(sum), 0.4, 0.0, 1.0);
}
