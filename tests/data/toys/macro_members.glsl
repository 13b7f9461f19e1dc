#define MEMBERS float a; float b;
struct S { MEMBERS };
void mainImage( out vec4 c, in vec2 p ) { S s; s.a = 1.; float q; c = vec4(s.a, q, 0., 1.); }
// expect 10 20: 255 0 0
