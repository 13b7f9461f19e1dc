#include "math/dialect.glsl"

// A Julia set of quaternions, cut by the space w = 0: the places from which z -> z^2 + c stays near, about the origin. |c| is at most 2; the set
// reaches to 2 at most. After `iterations` turns, from 1 to 30, what is within JULIA_BOUND counts as solid; more turns cut finer detail.
// Outside the result is less than the distance, and changes by at most a metre a metre; inside it has only the sign.
//
// The real part is z.x. The estimate is 0.5 log(r) r / stretch, where `stretch` is how far z moves for each metre of p.
//
// `trap` gets the least |x|, |y|, |z| and squared radius of the turns: for colours.
const float JULIA_BOUND = 2.0;
// Turns of one iteration, which compilers write out: a driver that limits the iterations of a draw (llvmpipe) would otherwise end the marches of
// some pixels.
const int JULIA_AT_ONCE = 4;

float distance_julia(vec3 p, vec4 c, int iterations, OUT(vec4) trap) {
    // Beyond this radius c is lost beside z^2, so that one more turn makes no difference.
    float escape = 8192.0;
    vec4 z = vec4(p, 0.0);
    float r = max(length(z), 1.0e-12);
    float stretch = 1.0;
    // The power of the turns that are left out.
    float left = exp2(float(iterations));
    trap = vec4(abs(p), r * r);
    for (int i = 0; i < iterations && r < escape; i += JULIA_AT_ONCE) {
        for (int k = 0; k < JULIA_AT_ONCE; k++) {
            if (i + k < iterations && r < escape) {
                stretch = max(2.0 * r * stretch, 1.0e-12);
                z = vec4(z.x * z.x - z.y * z.y - z.z * z.z - z.w * z.w, 2.0 * z.x * z.y, 2.0 * z.x * z.z, 2.0 * z.x * z.w) + c;
                r = max(length(z), 1.0e-12);
                trap = min(trap, vec4(abs(z.x), abs(z.y), abs(z.z), r * r));
                left *= 0.5;
            }
        }
    }
    float d = 0.5 * (log(r) - log(JULIA_BOUND) / left) * r / stretch;
    // Far away the logarithm is too much. No solid lies beyond 2, and at 2.2 the distance is 0.2 or more.
    return clamp(d, -1.0e-3, max(length(p) - 2.0, 0.2));
}

float distance_julia(vec3 p, vec4 c, int iterations) {
    vec4 trap = vec4(0.0);
    return distance_julia(p, c, iterations, trap);
}
