// Where the mist is. A region is closed in all directions or half of space, and has no surface that rays could miss or meet twice.
#include "scene.glsl"

// No ray is followed farther through mist, m. It is below INFINITY, so that products with it stay finite.
const float MIST_FARTHEST = 1.0e9;

// The distances along the ray at which it enters the region and leaves it. The second is smaller if the ray misses the region, and both may be behind
// the ray's origin.
vec2 mist_span(Ray ray);

// The part of the span within the ray's first metres: where it begins, and how long it is in metres.
vec2 mist_part(Ray ray, float distance) {
    vec2 span = mist_span(ray);
    float begin = max(span.x, 0.0);
    float metres = clamp(min(span.y, distance) - begin, 0.0, MIST_FARTHEST);
    return vec2(metres > 0.0 ? begin : 0.0, metres);
}
