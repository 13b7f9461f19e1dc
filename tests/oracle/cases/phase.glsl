// a: view, g; b: sun. c: Rayleigh's and Mie's phase.
#include "../item.glsl"
#include "sky/phase.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    c = vec4(rayleigh_phase(vec3(a), vec3(b)), mie_phase(a.w, vec3(a), vec3(b)), 0.0, 0.0);
    d = vec4(0.0);
}
