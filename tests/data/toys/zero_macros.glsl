// expect 10 20: 51 102 204
#define F float
#define V2 vec2
#define NUMBER F
#define LOOP(n) for (float k; k < n; k++)
#define PLAIN vec3 sum; float left;
V2 twice(in V2 x) { V2 y; y += 2.0 * x; return y; }
void mainImage(out vec4 O, in vec2 I) {
    F a, b = 0.1;
    NUMBER c;
    V2 p, q = twice(V2(0.2));
    PLAIN
    LOOP(4.0) sum.b += 0.2;
    O = vec4(a + c + 2.0 * b + p.x, q.y + left, sum.b, 1.0);
}
