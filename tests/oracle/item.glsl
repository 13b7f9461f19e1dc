// A case of many items: an item is a pair of neighbouring texels, a and b of the inputs, c and d of the results.
#include "inputs.glsl"
#include "math/dialect.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d);

vec4 evaluate(vec2 texel) {
    int first = int(texel.x) / 2 * 2;
    int row = int(texel.y);
    vec4 c = vec4(0.0);
    vec4 d = vec4(0.0);
    item(texelFetch(inputs, ivec2(first, row), 0), texelFetch(inputs, ivec2(first + 1, row), 0), c, d);
    return int(texel.x) == first ? c : d;
}
