// expect 3 4: 153 0 51
uniform float iGlobalTime;
float half_time = 0.5 * iGlobalTime;
void mainImage(out vec4 o, in vec2 p) { o = vec4(0.6 * half_time, 0.0, iGlobalTime * 0.1, 1.0); }
