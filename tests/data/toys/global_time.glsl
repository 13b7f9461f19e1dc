// expect 3 4: 102 51 0
#define T (iGlobalTime * 0.2)
void mainImage(out vec4 o, in vec2 p) { o = vec4(T, 0.1 * iGlobalTime, 0.0, 1.0); }
