// a: position. c: its colour.
#include "../item.glsl"
#include "color/checker.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    c = vec4(checker(vec3(a), vec3(0.8, 0.7, 0.6), vec3(0.1, 0.2, 0.3)), 0.0);
    d = vec4(0.0);
}
