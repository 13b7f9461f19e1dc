#include "math/dialect.glsl"

// An Apollonian gasket that fills space in cells of 2 metres, with a cell's middle in the origin: spheres that touch one another, which come from the plane
// y = 0 when space is folded into the cell and turned inside out in a sphere, again and again. `inversion` is that sphere's squared
// radius, from 1.1 to 1.5: less leaves finer lace. `iterations` is from 1 to 12.
//
// The spheres are skins without an inside: op_round() gives them a thickness, and op_intersection() a solid to be cut from.
// The result is less than the distance, and changes by at most a metre a metre.
//
// `trap` gets the least |x|, |y|, |z| and squared radius of the folded places: for colours.
//
// Folding keeps lengths, and an inversion multiplies all lengths at a place alike, so that the distance is about |y| / scale. It is so near the
// plane only: farther than APOLLONIAN_NEAR the scale differs too much on the way. APOLLONIAN_SAFE is measured.
const float APOLLONIAN_NEAR = 0.25;
const float APOLLONIAN_SAFE = 0.65;

float distance_apollonian(vec3 p, float inversion, int iterations, OUT(vec4) trap) {
    vec3 q = p;
    float scale = 1.0;
    trap = vec4(1.0e3);
    for (int i = 0; i < iterations; i++) {
        q = q - 2.0 * floor(0.5 * q + 0.5);
        float square = max(dot(q, q), 1.0e-12);
        trap = min(trap, vec4(abs(q), square));
        float grown = inversion / square;
        q *= grown;
        scale *= grown;
    }
    return APOLLONIAN_SAFE * min(abs(q.y), APOLLONIAN_NEAR) / scale;
}

float distance_apollonian(vec3 p, float inversion, int iterations) {
    vec4 trap = vec4(0.0);
    return distance_apollonian(p, inversion, iterations, trap);
}
