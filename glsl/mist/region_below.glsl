// Mist below a height, such as a layer on the ground.
#include "mist/region.glsl"
#include "mist/values.glsl"

vec2 mist_span(Ray ray) {
    float above = ray.origin.y - mist_middle().y;
    float slope = ray.direction.y;
    float ratio = -above / slope;
    float crossing = abs(slope) > 1.0e-20 ? ratio : INFINITY;
    bool rises = slope > 0.0;
    vec2 level = vec2(above < 0.0 ? 0.0 : INFINITY, above < 0.0 ? INFINITY : 0.0);
    vec2 tilted = vec2(rises ? 0.0 : crossing, rises ? crossing : INFINITY);
    return abs(slope) > 1.0e-20 ? tilted : level;
}
