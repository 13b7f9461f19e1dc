#include "math/dialect.glsl"

// The Menger sponge about `centre`: a cube of which each of `levels` steps cuts square holes, a third as wide, through every cube that is left.
// Exact outside; inside the distance is at least what is returned. `levels` is from 0 to 8.
//
// The sponge is symmetric in the planes that sort the coordinates, and two of its 20 smaller sponges lie where they are sorted. These two are mirror
// images, so that the nearest one is that on the point's side.
//
// `trap` gets the least |x|, |y| and |z|, sorted, of the places that the steps fold p to, and the square of their least distance from the middle.
float distance_menger(vec3 p, vec3 centre, float half_size, int levels, OUT(vec4) trap) {
    vec3 q = (p - centre) / half_size;
    float scale = half_size;
    vec3 sides = abs(q);
    float depth = half_size * (1.0 - max(max(sides.x, sides.y), sides.z));
    trap = vec4(1.0e3);
    for (int i = 0; i < levels; i++) {
        sides = abs(q);
        float high = max(max(sides.x, sides.y), sides.z);
        float low = min(min(sides.x, sides.y), sides.z);
        float middle = max(min(sides.x, sides.y), min(max(sides.x, sides.y), sides.z));
        trap = min(trap, vec4(high, middle, low, dot(q, q)));
        // The hole along the longest coordinate is the nearest one.
        depth = min(depth, scale * (middle - 1.0 / 3.0));
        q = 3.0 * vec3(high, middle, low) - vec3(2.0, 2.0, low > 1.0 / 3.0 ? 2.0 : 0.0);
        scale /= 3.0;
    }
    vec3 over = max(abs(q) - 1.0, 0.0);
    float outside = scale * length(over);
    return outside > 0.0 ? outside : -depth;
}

float distance_menger(vec3 p, vec3 centre, float half_size, int levels) {
    vec4 trap = vec4(0.0);
    return distance_menger(p, centre, half_size, levels, trap);
}
