// expect 10 20: 102 51 0
void mainImage(out vec4 O, in vec2 I) {
    float a, b = 0.2, c;
    vec2 p, q = vec2(0.4), r;
    int n;
    bool off;
    mat2 m;
    if (I.x < 0.0) a = c = 1.0, p = r = q, n = 4, off = true, m = mat2(1.0);
    O = vec4(q.x + a + c + p.x + r.y + float(n), b + m[0].x, off ? 1.0 : 0.0, 1.0);
}
