// Mist below a height, such as a layer on the ground.
#include "mist/region.glsl"
#include "mist/values.glsl"

vec2 mist_span(Ray ray) {
    float above = ray.origin.y - mist_middle().y;
    float slope = ray.direction.y;
    float crossing = abs(slope) > 1.0e-20 ? -above / slope : INFINITY;
    bool rises = slope > 0.0;
    vec2 level = above < 0.0 ? vec2(0.0, INFINITY) : vec2(INFINITY, 0.0);
    return abs(slope) > 1.0e-20 ? vec2(rises ? 0.0 : crossing, rises ? crossing : INFINITY) : level;
}
