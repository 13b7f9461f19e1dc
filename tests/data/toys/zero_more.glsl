#version 300 es
#define GLSLIFY 1
layout(origin_upper_left) in vec4 gl_FragCoord;
#define ADD(kk) { float extra; \
   vec2 two, three = vec2(.1); \
   sum += extra + two.x + three.y * kk; }
struct Ball { vec3 c; float r; };
struct Many { Ball balls[2]; int n; } kept_many;
uniform struct { vec3 a; } settings;
const float table[3] = float[](1.,2.,3.);
float f(float); float g;
float f(float x) { float y; return y + x; }
vec4 two(out Ball b[2], const in vec2 p, out int k);
vec4 two(out Ball b[2], const in vec2 p, out int k) { return vec4(b[0].r, b[1].c.x, float(k), 1.); }
void mainImage(out vec4 O, vec2 u)
{
    struct Local { float a; };
    vec2 R = iResolution.xy, U = (2.*u-R)/R.y;
    Ball b[2], c; Many m;
    int k, j[3], n = 3;
    float sum, i, t;
    vec3 d = vec3(0), e, h[2] = vec3[](vec3(1),vec3(2)), q[4];
    ADD(1.)
    for (O *= i; i++ < 9.; O += vec4(.01,.02,.03,0.)*table[1]);
    for (int i, w = 2; i < 3; i++) for (float jj, kk; jj < 2.; jj++) sum += kk + .01;
    if (u.x > 1e5) { k = 3; j[1] = 2; e = d; q[2].x = 4.; c.r = 3.; m.n = 4; m.balls[1].r = 3.; t = 3.; }
    O += two(b, U, k) + sum + e.x + q[n].y + c.r + float(m.n) + m.balls[1].r + float(j[2]) + g + t + f(0.) + (u.x > 0. ? 0. : 1.);
}
// expect 10 20: 87 133 178
