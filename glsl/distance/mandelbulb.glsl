#include "math/dialect.glsl"

// The Mandelbulb of White and Nylander about the origin and the y axis: the places p from which z -> z^power + p stays near. It reaches to about 1.2.
// `power` is a whole number from 4 to 15. After `iterations` turns, from 1 to 30, what is within MANDELBULB_BOUND counts as solid; more turns
// cut finer detail. Outside the result is less than the distance, and changes by at most 1.1 metres a metre; inside it has only the sign, and
// is steep where the detail is fine.
//
// The estimate is MANDELBULB_SAFE log(r) r / stretch, where `stretch` bounds how far z moves for each metre of p. The usual running derivative, power r^(power - 1),
// does not bound it: about the y axis the map stretches up to `power` times more, which made the usual estimate 17 times too long. `around` is
// that factor. It ends with a fraction of a turn, since the field would jump where a point escapes a turn later.
//
// `trap` gets the least |x|, |y|, |z| and squared radius of the turns: for colours.
const float MANDELBULB_BOUND = 2.0;
// Half of log(r) r / stretch would be right for a map that stretches alike in all directions. The field is measured to be steeper by up to a quarter.
const float MANDELBULB_SAFE = 0.4;

float distance_mandelbulb(vec3 p, float power, int iterations, OUT(vec4) trap) {
    // Beyond this radius p is lost beside z^power, so that one more turn makes no difference.
    float log_escape = 26.0 / power;
    float escape = exp2(log_escape);
    vec3 z = p;
    float r = max(length(z), 1.0e-12);
    float stretch = 1.0;
    // The power of the turns that are left out.
    float left = exp2(log2(power) * float(iterations));
    trap = vec4(abs(z), r * r);
    for (int i = 0; i < iterations && r < escape; i++) {
        if (r < escape) {
            // The angles are multiplied as powers of complex numbers, y + i across and z + i x.
            float across = max(sqrt(z.x * z.x + z.z * z.z), 1.0e-12 * r);
            vec4 base = vec4(z.y / r, across / r, z.z / across, z.x / across);
            vec4 turned = vec4(1.0, 0.0, 1.0, 0.0);
            float bits = power;
            for (int bit = 0; bit < 4; bit++) {
                vec4 more = vec4(turned.x * base.x - turned.y * base.y, turned.x * base.y + turned.y * base.x,
                                 turned.z * base.z - turned.w * base.w, turned.z * base.w + turned.w * base.z);
                turned = mod(bits, 2.0) > 0.5 ? more : turned;
                base = vec4(base.x * base.x - base.y * base.y, 2.0 * base.x * base.y, base.z * base.z - base.w * base.w,
                            2.0 * base.z * base.w);
                bits = floor(0.5 * bits);
            }
            float turn = clamp(log2(log_escape / max(log2(r), 1.0e-6)) / log2(power), 0.0, 1.0);
            float around = exp2(turn * log2(min(power, r / across)));
            float grown = exp2(power * log2(r));
            stretch = power * grown / r * around * stretch + 1.0;
            z = grown * vec3(turned.y * turned.w, turned.x, turned.y * turned.z) + p;
            r = max(length(z), 1.0e-12);
            trap = min(trap, vec4(abs(z), r * r));
            left /= power;
        }
    }
    float d = MANDELBULB_SAFE * (log(r) - log(MANDELBULB_BOUND) / left) * r / stretch;
    // Far away the logarithm is too much. No solid lies beyond 2, and at 2.2 the distance is 0.2 or more.
    return clamp(d, -1.0e-3, max(length(p) - 2.0, 0.2));
}

float distance_mandelbulb(vec3 p, float power, int iterations) {
    vec4 trap = vec4(0.0);
    return distance_mandelbulb(p, power, iterations, trap);
}
