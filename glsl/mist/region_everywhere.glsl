// Mist without bounds.
#include "mist/region.glsl"

vec2 mist_span(Ray ray) {
    return vec2(0.0, INFINITY);
}
