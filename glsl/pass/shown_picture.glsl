// A film of the window's own size.
#include "pass/shown_tone.glsl"

uniform sampler2D film_a;

vec3 shown_color(vec2 pixel, vec2 window) {
    vec4 sum = texelFetch(film_a, ivec2(pixel), 0);
    return developed(sum.rgb / max(sum.a, 1.0), uvec2(pixel));
}
