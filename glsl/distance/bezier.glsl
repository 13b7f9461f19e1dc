#include "math/dialect.glsl"

// Quadratic Bezier curves, from `from` to `to`, which start toward `bend` and arrive from there. The three points may lie on a line. The distances
// to the curve are exact; those inside a tube are, where the curve bends no tighter than the tube is wide.
//
// At the nearest point the square of the distance has no slope, or the curve ends. The slope f is a cubic of the place t on the curve, with
// at most two stretches where it rises. The nearest point of each stretch is found by halving it, so that nearly straight curves lose no digits.
float distance_bezier(vec3 p, vec3 from, vec3 bend, vec3 to) {
    vec3 a = bend - from;
    vec3 b = (to - bend) - a;
    vec3 d = from - p;
    float linear = 2.0 * dot(a, a) + dot(d, b);
    float square = 3.0 * dot(a, b);
    float cube = dot(b, b);
    // Between the turning points f falls.
    float root = sqrt(max(square * square - 3.0 * cube * linear, 0.0)) / max(3.0 * cube, 1.0e-30);
    float middle = -square / max(3.0 * cube, 1.0e-30);
    vec2 low = vec2(0.0, clamp(middle + root, 0.0, 1.0));
    vec2 high = vec2(clamp(middle - root, 0.0, 1.0), 1.0);
    // Without turning points one of the stretches is the whole curve.
    high.x = square * square > 3.0 * cube * linear ? high.x : 1.0;
    for (int i = 0; i < 24; i++) {
        vec2 t = 0.5 * (low + high);
        vec2 f = ((cube * t + square) * t + linear) * t + dot(d, a);
        vec2 before = step(f, vec2(0.0));
        low = mix(low, t, before);
        high = mix(t, high, before);
    }
    vec2 t = 0.5 * (low + high);
    float one = length(d + t.x * (2.0 * a + t.x * b));
    float other = length(d + t.y * (2.0 * a + t.y * b));
    return min(one, other);
}

// All points within `radius` of the curve.
float distance_bezier_tube(vec3 p, vec3 from, vec3 bend, vec3 to, float radius) {
    return distance_bezier(p, from, bend, to) - radius;
}

// The curve in a plane. It has no inside: op_round() gives it a width.
float distance_quadratic_bezier(vec2 p, vec2 from, vec2 bend, vec2 to) {
    return distance_bezier(vec3(p, 0.0), vec3(from, 0.0), vec3(bend, 0.0), vec3(to, 0.0));
}
