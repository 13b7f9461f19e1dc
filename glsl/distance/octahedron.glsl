#include "math/dialect.glsl"

// Distance to a regular octahedron, `radius` from its centre to its corners on the axes. The distance is exact.
//
// One face, x + y + z = radius with no coordinate below 0, stands for all eight. Its nearest point is max(q - shift, 0), with the shift for which its
// coordinates sum to the radius. The shift is the largest of those that one, two or all three coordinates would need (the projection
// to a simplex: Held, Wolfe and Crowder 1974).
float distance_octahedron(vec3 p, vec3 centre, float radius) {
    vec3 q = abs(p - centre);
    float sum = q.x + q.y + q.z;
    float one = max(max(q.x, q.y), q.z) - radius;
    float two = 0.5 * (sum - min(min(q.x, q.y), q.z) - radius);
    float three = (sum - radius) / 3.0;
    vec3 nearest = max(q - max(max(one, two), three), vec3(0.0));
    return (sum < radius ? -1.0 : 1.0) * length(q - nearest);
}
