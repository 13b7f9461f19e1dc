#iChannel0 "file://picture.png"
#iChannel1 "self"
// expect 10 20: 102 0 0
void mainImage(out vec4 O, in vec2 I) { O = vec4(0.4, 0.0, 0.0, 1.0); }
