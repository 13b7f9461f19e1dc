// expect 10 20: 204 0 255
void mainImage(out vec4 O, vec2 I) {
    vec4 sum;
    for (float i, step = 1.0; i < 4.0; i += step) sum += vec4(0.2, 0.0, 0.25, 0.0);
    for (O *= 0.0; O.a++ < 1.0;) O.rgb += sum.rgb;
}
