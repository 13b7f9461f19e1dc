#version 330
// expect 3 4: 255 102 0
void mainImage(out vec4 o, in vec2 p) { o = vec4(1.0, 0.4, 0.0, 1.0); }
