// expect 3 4: 255 0 128
void mainImage(out vec4 O, in vec2 I) { O = vec4(3.0, -1.0, 128.0 / 255.0, 0.0); }
