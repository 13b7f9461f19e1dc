// expect 10 20: 51 51 102
vec2 mainSound(in int sample_number, float t) { return vec2(0.0); }
void mainVR(out vec4 c, in vec2 p, in vec3 origin, in vec3 direction) { c = vec4(1.0); }
void mainImage(out vec4 O, in vec2 I) { O = vec4(0.2, 0.2, 0.4, 1.0); }
